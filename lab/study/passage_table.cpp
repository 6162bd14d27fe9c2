// SPDX-License-Identifier: BSD-3-Clause
#include "study/passage_table.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

const std::vector<std::string>& columns_of_passages() {
  static const std::vector<std::string> all{"id",       "drive",          "setting",  "seed",     "ending",
                                            "arrived",  "steady",         "duration", "stops",    "longest_stand",
                                            "standing", "length",         "contacts", "v_change", "omega_change",
                                            "acc_rms",  "share_at_limit", "failures", "brakes"};
  return all;
}

double measure_of(const Row& row, const std::string& column) { return value(row, column, columns_of_passages()); }

// The drives of one setting.
struct Passages {
  std::string setting;
  std::vector<Row> rows;

  double sum(const std::string& column) const {
    double all = 0.0;
    for (const Row& row : rows) all += measure_of(row, column);
    return all;
  }
  double mean(const std::string& column) const { return sum(column) / static_cast<double>(rows.size()); }
  double most(const std::string& column) const {
    double most = 0.0;
    for (const Row& row : rows) most = std::max(most, measure_of(row, column));
    return most;
  }
  long above(const std::string& column, double bound) const {
    return std::count_if(rows.begin(), rows.end(), [&](const Row& row) { return measure_of(row, column) > bound; });
  }
  long arrived() const { return above("arrived", 0.5); }
  long stood_long() const { return above("longest_stand", kLongestStand); }
  long stopped_often() const { return above("stops", kMostStops); }
};

std::vector<Passages> passages_of(const Plan& plan, const std::vector<Row>& rows) {
  std::vector<Passages> groups;
  for (const Setting& setting : plan.settings) {
    Passages group{to_string(setting), {}};
    for (const Row& row : rows) {
      if (cell(row, "setting", columns_of_passages()) == group.setting) group.rows.push_back(row);
    }
    if (!group.rows.empty()) groups.push_back(group);
  }
  return groups;
}

nlohmann::json json_of(const Passages& group) {
  return {{"setting", group.setting},
          {"n", group.rows.size()},
          {"arrived", group.arrived()},
          {"stood_long", group.stood_long()},
          {"stopped_often", group.stopped_often()},
          {"most_stops", group.most("stops")},
          {"mean_stops", group.mean("stops")},
          {"longest_stand", group.most("longest_stand")},
          {"standing", group.mean("standing")},
          {"duration", group.mean("duration")},
          {"v_change", group.mean("v_change")},
          {"acc_rms", group.mean("acc_rms")},
          {"share_at_limit", group.mean("share_at_limit")},
          {"contacts", group.sum("contacts")},
          {"failures", group.mean("failures")}};
}

std::string summary_of_passages(const Plan& plan, const std::vector<Row>& rows) {
  nlohmann::json all = nlohmann::json::array();
  for (const Passages& group : passages_of(plan, rows)) all.push_back(json_of(group));
  const nlohmann::json summary = {
      {"experiment", plan.experiment}, {"runs_planned", plan.runs.size()}, {"runs", rows.size()}, {"groups", all}};
  return summary.dump(2) + '\n';
}

// The best first: fewest contacts, most steady drives, least time.
std::string ranking_of_passages(const Plan& plan, const std::vector<Row>& rows) {
  std::vector<Passages> ranked = passages_of(plan, rows);
  const auto merit = [](const Passages& group) {
    return std::make_tuple(group.mean("contacts"), -group.mean("steady"), group.mean("duration"));
  };
  std::stable_sort(ranked.begin(), ranked.end(),
                   [&merit](const Passages& a, const Passages& b) { return merit(a) < merit(b); });
  std::string csv = "rank,setting,n,arrived,steady,duration,mean_stops,longest_stand\n";
  int rank = 0;
  for (const Passages& group : ranked) {
    csv += std::to_string(++rank) + ',' + group.setting + ',' + std::to_string(group.rows.size()) + ',' +
           std::to_string(group.arrived());
    for (const double value :
         {group.mean("steady"), group.mean("duration"), group.mean("stops"), group.most("longest_stand")}) {
      csv += ',' + number(value);
    }
    csv += '\n';
  }
  return csv;
}

std::string digest_of_passages(const Plan& plan, const std::vector<Row>& rows) {
  std::string lines;
  for (const Passages& group : passages_of(plan, rows)) {
    lines += group.setting + ": " +
             format(
                 "n %zu, arrived %ld, %.1f s, worst stand %.2f s (%ld above %.0f s), stops %.2f, at most %.0f (%ld "
                 "above %d), contacts %.0f\n",
                 group.rows.size(), group.arrived(), group.mean("duration"), group.most("longest_stand"),
                 group.stood_long(), kLongestStand, group.mean("stops"), group.most("stops"), group.stopped_often(),
                 kMostStops, group.sum("contacts"));
  }
  return lines;
}

}  // namespace

Tables passage_tables() {
  return {columns_of_passages(), summary_of_passages, ranking_of_passages, digest_of_passages};
}

Row passage_row(const Plan& plan, const Run& run, std::uint64_t world_seed, const drive::DriveResult& r,
                const Passage& passage) {
  const bool steady =
      r.arrived && r.contacts == 0 && passage.longest_stand <= kLongestStand && passage.stops <= kMostStops;
  return {run.id,
          std::to_string(run.participant),
          to_string(plan.settings[run.setting]),
          std::to_string(world_seed),
          drive::to_string(r.ending),
          r.arrived ? "1" : "0",
          steady ? "1" : "0",
          number(r.duration),
          std::to_string(passage.stops),
          number(passage.longest_stand),
          number(passage.standing),
          number(r.length),
          std::to_string(r.contacts),
          number(r.v_change),
          number(r.omega_change),
          number(r.gentleness.acc_rms),
          number(r.gentleness.at_limit),
          std::to_string(r.failures),
          std::to_string(r.brakes)};
}

}  // namespace study
}  // namespace hidwa_local_planner
