// SPDX-License-Identifier: BSD-3-Clause
#include "study/barn_table.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <nlohmann/json.hpp>

#include "core/util/words.hpp"
#include "study/summary.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

const std::vector<std::string>& names() {
  static const std::vector<std::string> all{
      "id",        "world",           "mode",           "setting",  "seed",
      "ending",    "success",         "collision",      "timeout",  "time",
      "metric",    "optimal_time",    "path_clearance", "length",   "contacts",
      "clearance", "operator_active", "interventions",  "v_change", "omega_change",
      "agreement", "failures",        "brakes"};
  return all;
}

const std::string& text_of(const Row& row, const std::string& column) { return cell(row, column, names()); }
double number_of(const Row& row, const std::string& column) { return value(row, column, names()); }

struct ModeGroup {
  std::string mode, setting;
  std::vector<Row> rows;

  double mean(const std::string& column) const {
    double sum = 0.0;
    for (const Row& row : rows) sum += number_of(row, column);
    return rows.empty() ? 0.0 : sum / static_cast<double>(rows.size());
  }
  double mean_time_of_successes() const {
    double sum = 0.0, n = 0.0;
    for (const Row& row : rows) {
      if (text_of(row, "success") != "1") continue;
      sum += number_of(row, "time");
      n += 1.0;
    }
    return n > 0.0 ? sum / n : 0.0;
  }
  long count(const std::string& column) const { return std::lround(mean(column) * static_cast<double>(rows.size())); }
  double least(const std::string& column) const {
    double value = number_of(rows.front(), column);
    for (const Row& row : rows) value = std::min(value, number_of(row, column));
    return value;
  }
};

std::vector<ModeGroup> mode_groups(const Plan& plan, const std::vector<Row>& rows) {
  std::vector<ModeGroup> groups;
  for (const Setting& setting : plan.settings) {
    for (const std::string& mode : barn_modes()) {
      ModeGroup group{mode, to_string(setting), {}};
      for (const Row& row : rows) {
        if (text_of(row, "mode") == mode && text_of(row, "setting") == group.setting) group.rows.push_back(row);
      }
      if (!group.rows.empty()) groups.push_back(group);
    }
  }
  return groups;
}

nlohmann::json json_of(const ModeGroup& group) {
  return {{"mode", group.mode},
          {"setting", group.setting},
          {"n", group.rows.size()},
          {"success", group.mean("success")},
          {"collision", group.mean("collision")},
          {"timeout", group.mean("timeout")},
          {"time_of_successes", group.mean_time_of_successes()},
          {"metric", group.mean("metric")},
          {"contacts", group.count("contacts")},
          {"least_clearance", group.least("clearance")},
          {"operator_active", group.mean("operator_active")}};
}

std::string summary(const Plan& plan, const std::vector<Row>& rows) {
  nlohmann::json all = nlohmann::json::array();
  for (const ModeGroup& group : mode_groups(plan, rows)) all.push_back(json_of(group));
  const nlohmann::json summary = {
      {"experiment", plan.experiment}, {"runs_planned", plan.runs.size()}, {"runs", rows.size()}, {"groups", all}};
  return summary.dump(2) + '\n';
}

// The best first: fewest contacts, then the greatest metric, most successes.
std::string ranking(const Plan& plan, const std::vector<Row>& rows) {
  std::vector<ModeGroup> ranked = mode_groups(plan, rows);
  const auto merit = [](const ModeGroup& group) {
    return std::make_tuple(group.mean("contacts"), -group.mean("metric"), -group.mean("success"));
  };
  std::stable_sort(ranked.begin(), ranked.end(),
                   [&merit](const ModeGroup& a, const ModeGroup& b) { return merit(a) < merit(b); });
  std::string csv = "rank,mode,setting,n,success,collision,timeout,time_of_successes,metric\n";
  int rank = 0;
  for (const ModeGroup& group : ranked) {
    csv += std::to_string(++rank) + ',' + group.mode + ',' + group.setting + ',' + std::to_string(group.rows.size());
    for (const double value : {group.mean("success"), group.mean("collision"), group.mean("timeout"),
                               group.mean_time_of_successes(), group.mean("metric")}) {
      csv += ',' + number(value);
    }
    csv += '\n';
  }
  return csv;
}

std::string digest(const Plan& plan, const std::vector<Row>& rows) {
  std::string lines;
  for (const ModeGroup& group : mode_groups(plan, rows)) {
    lines += group.mode + " " + group.setting + ": ";
    lines += format(
        "n %zu, success %.3f, collision %.3f, timeout %.3f, %.1f s, metric %.3f, contacts %ld, "
        "least clearance %.3f m\n",
        group.rows.size(), group.mean("success"), group.mean("collision"), group.mean("timeout"),
        group.mean_time_of_successes(), group.mean("metric"), group.count("contacts"), group.least("clearance"));
  }
  return lines;
}

}  // namespace

Tables barn_tables() { return {names(), summary, ranking, digest}; }

Row barn_row(const Plan& plan, const Run& run, std::uint64_t world_seed, const drive::DriveResult& r,
             const BarnScore& score) {
  const bool collision = r.contacts > 0;
  return {run.id,
          std::to_string(run.participant),
          run.condition,
          to_string(plan.settings[run.setting]),
          std::to_string(world_seed),
          drive::to_string(r.ending),
          score.success ? "1" : "0",
          collision ? "1" : "0",
          score.success || collision ? "0" : "1",
          number(r.duration),
          number(score.metric),
          number(score.optimal_time),
          number(score.path_clearance),
          number(r.length),
          std::to_string(r.contacts),
          number(r.clearance),
          number(r.operator_active),
          std::to_string(r.interventions),
          number(r.v_change),
          number(r.omega_change),
          number(r.agreement),
          std::to_string(r.failures),
          std::to_string(r.brakes)};
}

}  // namespace study
}  // namespace hidwa_local_planner
