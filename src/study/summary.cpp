// SPDX-License-Identifier: BSD-3-Clause
#include "study/summary.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

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

std::string group_json(const Group& group) {
  std::string json = "    {\"condition\": \"" + group.condition + "\", \"setting\": \"" + group.setting +
                     "\", \"n\": " + std::to_string(group.rows.size()) +
                     ", \"arrived\": " + std::to_string(std::lround(sum(group, "arrived"))) + ", \"measures\": {\n";
  for (const std::string& measure : measures()) {
    const Statistics s = statistics(values(group, measure));
    json += "      \"" + measure + "\": {\"mean\": " + number(s.mean) + ", \"median\": " + number(s.median) +
            ", \"sd\": " + number(s.sd) + ", \"min\": " + number(s.min) + ", \"max\": " + number(s.max) + "}" +
            (measure == measures().back() ? "\n" : ",\n");
  }
  return json + "    }}";
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
  std::string json = "{\n  \"experiment\": \"" + plan.experiment +
                     "\",\n  \"runs_planned\": " + std::to_string(plan.runs.size()) +
                     ",\n  \"runs\": " + std::to_string(rows.size()) + ",\n  \"groups\": [";
  const char* before = "\n";
  for (const Group& group : groups(plan, rows)) {
    json += before + group_json(group);
    before = ",\n";
  }
  return json + "\n  ]\n}\n";
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
