// SPDX-License-Identifier: BSD-3-Clause
#include "study/summary.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <nlohmann/json.hpp>

namespace hidwa_local_planner {
namespace study {
namespace {

std::vector<double> values(const Group& group, const std::string& measure) {
  std::vector<double> all;
  for (const Row& row : group.rows) all.push_back(value(row, measure));
  return all;
}

double sum(const Group& group, const std::string& measure) {
  double total = 0.0;
  for (const Row& row : group.rows) total += value(row, measure);
  return total;
}

double mean(const Group& group, const std::string& measure) {
  return sum(group, measure) / static_cast<double>(group.rows.size());
}

nlohmann::json json_of(const Group& group) {
  nlohmann::json all = nlohmann::json::object();
  for (const std::string& measure : measures()) {
    const Statistics s = statistics(values(group, measure));
    all[measure] = {{"mean", s.mean}, {"median", s.median}, {"sd", s.sd}, {"min", s.min}, {"max", s.max}};
  }
  return {{"condition", group.condition},
          {"setting", group.setting},
          {"n", group.rows.size()},
          {"arrived", std::lround(sum(group, "arrived"))},
          {"measures", all}};
}

}  // namespace

Statistics statistics(std::vector<double> values) {
  Statistics s;
  if (values.empty()) return s;
  const auto n = static_cast<double>(values.size());
  for (const double value : values) s.mean += value / n;
  double squares = 0.0;
  for (const double value : values) squares += (value - s.mean) * (value - s.mean);
  if (values.size() > 1) s.sd = std::sqrt(squares / (n - 1.0));
  std::sort(values.begin(), values.end());
  s.min = values.front();
  s.max = values.back();
  s.median = 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
  return s;
}

std::vector<Group> groups(const Plan& plan, const std::vector<Row>& rows) {
  std::vector<Group> all;
  for (const Setting& setting : plan.settings) {
    for (const char* condition : {"SJ", "SG", "SW"}) {
      Group group{condition, to_string(setting), {}};
      for (const Row& row : rows) {
        if (cell(row, "condition") == group.condition && cell(row, "setting") == group.setting) {
          group.rows.push_back(row);
        }
      }
      if (!group.rows.empty()) all.push_back(group);
    }
  }
  return all;
}

std::string summary_json(const Plan& plan, const std::vector<Row>& rows) {
  nlohmann::json all = nlohmann::json::array();
  for (const Group& group : groups(plan, rows)) all.push_back(json_of(group));
  const nlohmann::json summary = {
      {"experiment", plan.experiment}, {"runs_planned", plan.runs.size()}, {"runs", rows.size()}, {"groups", all}};
  return summary.dump(2) + '\n';
}

std::string ranking_csv(const Plan& plan, const std::vector<Row>& rows) {
  std::vector<Group> ranked = groups(plan, rows);
  const auto merit = [](const Group& group) {
    return std::make_tuple(-mean(group, "arrived"), mean(group, "contacts"), mean(group, "regions_crossed"),
                           mean(group, "duration"));
  };
  std::stable_sort(ranked.begin(), ranked.end(),
                   [&merit](const Group& a, const Group& b) { return merit(a) < merit(b); });
  std::string csv = "rank,condition,setting,n,arrived";
  for (const std::string& measure : measures()) csv += ",mean_" + measure;
  csv += '\n';
  int rank = 0;
  for (const Group& group : ranked) {
    csv += std::to_string(++rank) + ',' + group.condition + ',' + group.setting + ',' +
           std::to_string(group.rows.size()) + ',' + std::to_string(std::lround(sum(group, "arrived")));
    for (const std::string& measure : measures()) csv += ',' + number(mean(group, measure));
    csv += '\n';
  }
  return csv;
}

}  // namespace study
}  // namespace hidwa_local_planner
