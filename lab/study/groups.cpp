// SPDX-License-Identifier: BSD-3-Clause
#include "study/groups.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

Group group_of(const Row& row, const Tables& tables) {
  Group group;
  group.columns = &tables.columns;
  for (const std::string& key : tables.keys) group.names.push_back(cell(row, key, tables.columns));
  return group;
}

// `order`: of everything by which groups are sorted.
std::vector<std::ptrdiff_t> place_of(const Group& group, const Tables& tables, const std::vector<std::string>& order) {
  std::vector<std::ptrdiff_t> place;
  for (const std::string& key : tables.sorted_by) {
    const std::string& name = cell(group.names, key, tables.keys);
    place.push_back(std::find(order.begin(), order.end(), name) - order.begin());
  }
  return place;
}

// Those of ranking.csv too.
nlohmann::json all_figures(const Group& group, const Tables& tables) {
  nlohmann::json figures = tables.figures(group);
  figures.update(tables.only_ranked(group));
  return figures;
}

// Whole numbers have no decimals.
std::string written(const nlohmann::json& figure, int decimals) {
  return figure.is_number_float() ? fixed(figure.get<double>(), decimals) : figure.dump();
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

std::string Group::name() const {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : " ") + name;
  return all;
}

std::vector<double> Group::values(const std::string& column) const {
  std::vector<double> all;
  for (const Row& row : rows) all.push_back(value(row, column, *columns));
  return all;
}

double Group::sum(const std::string& column) const {
  const std::vector<double> all = values(column);
  return std::accumulate(all.begin(), all.end(), 0.0);
}

double Group::mean(const std::string& column) const { return sum(column) / static_cast<double>(rows.size()); }

double Group::most(const std::string& column) const { return statistics(values(column)).max; }

long Group::count(const std::string& column) const { return std::lround(sum(column)); }

long Group::above(const std::string& column, double bound) const {
  const std::vector<double> all = values(column);
  return std::count_if(all.begin(), all.end(), [bound](double value) { return value > bound; });
}

double Group::share(const std::string& column) const {
  return static_cast<double>(above(column, 0.0)) / static_cast<double>(rows.size());
}

double Group::time_of_successes() const {
  Group successes{names, place, columns, {}};
  for (const Row& row : rows) {
    if (cell(row, "success", *columns) == "1") successes.rows.push_back(row);
  }
  return successes.rows.empty() ? 0.0 : successes.mean("time");
}

std::vector<Group> groups(const Tables& tables, const Plan& plan, const std::vector<Row>& rows) {
  std::vector<std::string> order = tables.order;
  for (const Setting& setting : plan.settings) order.push_back(to_string(setting));
  std::vector<Group> all;
  for (const Row& row : rows) {
    Group own = group_of(row, tables);
    auto group = std::find_if(all.begin(), all.end(), [&own](const Group& other) { return other.names == own.names; });
    if (group == all.end()) {
      own.place = place_of(own, tables, order);
      group = all.insert(all.end(), own);
    }
    group->rows.push_back(row);
  }
  std::stable_sort(all.begin(), all.end(), [](const Group& a, const Group& b) { return a.place < b.place; });
  return all;
}

std::string summary_json(const Tables& tables, const Plan& plan, const std::vector<Row>& rows) {
  nlohmann::json all = nlohmann::json::array();
  for (const Group& group : groups(tables, plan, rows)) {
    nlohmann::json figures = tables.figures(group);
    for (const std::string& key : tables.keys) figures[key] = cell(group.names, key, tables.keys);
    figures[tables.count_name] = group.rows.size();
    all.push_back(figures);
  }
  const nlohmann::json summary = {
      {"experiment", plan.experiment}, {"runs_planned", plan.runs.size()}, {"runs", rows.size()}, {"groups", all}};
  return summary.dump(2) + '\n';
}

std::string ranking_csv(const Tables& tables, const Plan& plan, const std::vector<Row>& rows) {
  std::vector<Group> ranked = groups(tables, plan, rows);
  std::stable_sort(ranked.begin(), ranked.end(),
                   [&tables](const Group& a, const Group& b) { return tables.merit(a) < tables.merit(b); });
  std::string csv = "rank," + to_line(tables.keys) + ',' + tables.count_name + ',' + to_line(tables.ranked) + '\n';
  int rank = 0;
  for (const Group& group : ranked) {
    csv += std::to_string(++rank) + ',' + to_line(group.names) + ',' + std::to_string(group.rows.size());
    const nlohmann::json figures = all_figures(group, tables);
    for (const std::string& name : tables.ranked) csv += ',' + written(figures.at(name), 6);
    csv += '\n';
  }
  return csv;
}

std::string digest(const Tables& tables, const Plan& plan, const std::vector<Row>& rows) {
  std::string lines;
  for (const Group& group : groups(tables, plan, rows)) {
    const nlohmann::json figures = all_figures(group, tables);
    lines += group.name() + ": " + tables.count_name + ' ' + std::to_string(group.rows.size());
    for (const std::string& name : tables.told) lines += ", " + name + ' ' + written(figures.at(name), 3);
    lines += '\n';
  }
  return lines;
}

}  // namespace study
}  // namespace hidwa_local_planner
