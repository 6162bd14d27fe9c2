// SPDX-License-Identifier: BSD-3-Clause
#include "study/table.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace hidwa_local_planner {
namespace study {
namespace {

constexpr std::size_t kNotMeasured = 9;  // columns

std::string decimals(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  // "-0.00" is 0.00.
  const std::string all(text);
  const bool zero = all.find_first_not_of("-0.") == std::string::npos;
  return zero && all.front() == '-' ? all.substr(1) : all;
}

}  // namespace

const std::vector<std::string>& columns() {
  static const std::vector<std::string> names{
      "id",        "experiment",      "participant",   "condition", "order",        "setting",
      "seed",      "ending",          "arrived",       "duration",  "length",       "regions_crossed",
      "contacts",  "operator_active", "interventions", "v_change",  "omega_change", "agreement",
      "clearance", "mode_errors",     "failures",      "brakes"};
  return names;
}

const std::vector<std::string>& measures() {
  static const std::vector<std::string> names(columns().begin() + kNotMeasured, columns().end());
  return names;
}

std::string number(double value) { return decimals("%.6f", value); }

Row row_of(const Plan& plan, const Run& run, std::uint64_t world_seed, const Driven& driven) {
  const drive::DriveResult& r = driven.result;
  return {run.id,
          plan.experiment,
          std::to_string(run.participant),
          run.condition,
          std::to_string(run.order),
          to_string(plan.settings[run.setting]),
          std::to_string(world_seed),
          drive::to_string(r.ending),
          r.arrived ? "1" : "0",
          number(r.duration),
          number(r.length),
          std::to_string(r.regions_crossed),
          std::to_string(r.contacts),
          number(r.operator_active),
          std::to_string(r.interventions),
          number(r.v_change),
          number(r.omega_change),
          number(r.agreement),
          number(r.clearance),
          std::to_string(driven.errors),
          std::to_string(r.failures),
          std::to_string(r.brakes)};
}

const std::string& cell(const Row& row, const std::string& column) {
  const auto found = std::find(columns().begin(), columns().end(), column);
  if (found == columns().end()) throw std::logic_error("no column " + column);
  return row.at(static_cast<std::size_t>(found - columns().begin()));
}

double value(const Row& row, const std::string& column) { return std::strtod(cell(row, column).c_str(), nullptr); }

std::string to_line(const Row& row) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) line += (i == 0 ? "" : ",") + row[i];
  return line;
}

Row from_line(const std::string& line) {
  Row row(1);
  for (const char c : line) {
    if (c == ',') {
      row.emplace_back();
    } else if (c != '\n' && c != '\r') {
      row.back() += c;
    }
  }
  return row;
}

std::string path_csv(const drive::DriveResult& result) {
  std::string csv = "t,x,y,theta,v,omega,state\n";
  for (const drive::DriveSample& sample : result.samples) {
    csv += decimals("%.2f", sample.time) + ',' + decimals("%.3f", sample.pose.x) + ',' +
           decimals("%.3f", sample.pose.y) + ',' + decimals("%.3f", sample.pose.theta) + ',' +
           decimals("%.3f", sample.command.v) + ',' + decimals("%.3f", sample.command.omega) + ',' +
           hidwa_local_planner::to_string(sample.state) + '\n';
  }
  return csv;
}

}  // namespace study
}  // namespace hidwa_local_planner
