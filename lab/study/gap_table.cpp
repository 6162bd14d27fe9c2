// SPDX-License-Identifier: BSD-3-Clause
#include "study/gap_table.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/util/words.hpp"
#include "study/summary.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

const std::vector<std::string>& columns_of_gaps() {
  static const std::vector<std::string> all{"id",    "outline", "setting", "resolution", "noise",
                                            "phase", "padded",  "width",   "drives",     "duration"};
  return all;
}

double length_in(const Row& row, const std::string& column) { return value(row, column, columns_of_gaps()); }
const std::string& word_in(const Row& row, const std::string& column) { return cell(row, column, columns_of_gaps()); }

// All phases of one outline and setting.
struct Phases {
  std::string outline, setting;
  double padded = 0.0, resolution = 0.0, noise = 0.0;  // [m]
  Statistics width;                                    // [m]
  std::size_t count = 0;
};

std::vector<Phases> phases_of(const Plan& plan, const std::vector<Row>& rows) {
  std::vector<Phases> groups;
  for (const std::string& outline : gap_outlines()) {
    for (const Setting& setting : plan.settings) {
      Phases group;
      group.outline = outline;
      group.setting = to_string(setting);
      std::vector<double> widths;
      for (const Row& row : rows) {
        if (word_in(row, "outline") != outline || word_in(row, "setting") != group.setting) continue;
        group.padded = length_in(row, "padded");
        group.resolution = length_in(row, "resolution");
        group.noise = length_in(row, "noise");
        widths.push_back(length_in(row, "width"));
      }
      if (widths.empty()) continue;
      group.count = widths.size();
      group.width = statistics(widths);
      groups.push_back(group);
    }
  }
  return groups;
}

std::string summary_of_gaps(const Plan& plan, const std::vector<Row>& rows) {
  nlohmann::json all = nlohmann::json::array();
  for (const Phases& group : phases_of(plan, rows)) {
    all.push_back({{"outline", group.outline},
                   {"setting", group.setting},
                   {"phases", group.count},
                   {"padded", group.padded},
                   {"resolution", group.resolution},
                   {"noise", group.noise},
                   {"least", group.width.min},
                   {"mean", group.width.mean},
                   {"most", group.width.max}});
  }
  const nlohmann::json summary = {
      {"experiment", plan.experiment}, {"runs_planned", plan.runs.size()}, {"runs", rows.size()}, {"groups", all}};
  return summary.dump(2) + '\n';
}

std::string ranking_of_gaps(const Plan& plan, const std::vector<Row>& rows) {
  std::vector<Phases> ranked = phases_of(plan, rows);
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Phases& a, const Phases& b) { return a.width.mean < b.width.mean; });
  std::string csv = "rank,outline,setting,phases,least,mean,most\n";
  int rank = 0;
  for (const Phases& group : ranked) {
    csv += std::to_string(++rank) + ',' + group.outline + ',' + group.setting + ',' + std::to_string(group.count) +
           ',' + number(group.width.min) + ',' + number(group.width.mean) + ',' + number(group.width.max) + '\n';
  }
  return csv;
}

std::string digest_of_gaps(const Plan& plan, const std::vector<Row>& rows) {
  std::string lines = "outline  padded  cells   noise   narrowest gap: least  mean   most [m]\n";
  for (const Phases& group : phases_of(plan, rows)) {
    lines += format("%-7s  %.3f   %.3f   %.3f                  %.2f   %.3f  %.2f\n", group.outline.c_str(),
                    group.padded, group.resolution, group.noise, group.width.min, group.width.mean, group.width.max);
  }
  return lines;
}

}  // namespace

Tables gap_tables() { return {columns_of_gaps(), summary_of_gaps, ranking_of_gaps, digest_of_gaps}; }

Row gap_row(const Plan& plan, const Run& run, double phase, const GapSubject& subject, const Narrowest& narrowest) {
  return {run.id,
          run.condition,
          to_string(plan.settings[run.setting]),
          number(subject.resolution),
          number(subject.noise),
          number(phase),
          number(width_of(run.condition) + 2.0 * subject.padding),
          number(narrowest.width),
          std::to_string(narrowest.drives),
          number(narrowest.result.duration)};
}

}  // namespace study
}  // namespace hidwa_local_planner
