// SPDX-License-Identifier: BSD-3-Clause
#include "study/table.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

constexpr std::size_t kNotMeasured = 9;  // columns

}  // namespace

const std::vector<std::string>& columns() {
  static const std::vector<std::string> names{
      "id",           "experiment",      "participant",   "condition", "order",         "setting",
      "seed",         "ending",          "arrived",       "duration",  "length",        "regions_crossed",
      "contacts",     "operator_active", "interventions", "v_change",  "omega_change",  "agreement",
      "clearance",    "mode_errors",     "failures",      "brakes",    "acc_rms",       "acc_p99",
      "bend_acc_rms", "jerk_rms",        "jerk_p99",      "at_limit",  "bend_at_limit", "mean_clearance"};
  return names;
}

const std::vector<std::string>& measures() {
  static const std::vector<std::string> names(columns().begin() + kNotMeasured, columns().end());
  return names;
}

std::string number(double value) { return fixed(value, 6); }

Row row_in(const std::vector<std::string>& names, const Plan& plan, const Run& run, std::uint64_t world_seed,
           const drive::DriveResult& r, std::map<std::string, std::string> own) {
  own.insert({{"id", run.id},
              {"experiment", plan.experiment},
              {"participant", std::to_string(run.participant)},
              {"condition", run.condition},
              {"order", std::to_string(run.order)},
              {"setting", to_string(plan.settings[run.setting])},
              {"seed", std::to_string(world_seed)},
              {"ending", drive::to_string(r.ending)},
              {"arrived", r.arrived ? "1" : "0"},
              {"duration", number(r.duration)},
              {"length", number(r.length)},
              {"regions_crossed", std::to_string(r.regions_crossed)},
              {"contacts", std::to_string(r.contacts)},
              {"operator_active", number(r.operator_active)},
              {"interventions", std::to_string(r.interventions)},
              {"v_change", number(r.v_change)},
              {"omega_change", number(r.omega_change)},
              {"agreement", number(r.agreement)},
              {"clearance", number(r.clearance)},
              {"failures", std::to_string(r.failures)},
              {"brakes", std::to_string(r.brakes)},
              {"acc_rms", number(r.gentleness.acc_rms)},
              {"acc_p99", number(r.gentleness.acc_p99)},
              {"bend_acc_rms", number(r.gentleness.bend_acc_rms)},
              {"jerk_rms", number(r.gentleness.jerk_rms)},
              {"jerk_p99", number(r.gentleness.jerk_p99)},
              {"at_limit", number(r.gentleness.at_limit)},
              {"bend_at_limit", number(r.gentleness.bend_at_limit)},
              {"mean_clearance", number(r.mean_clearance)}});
  Row row;
  for (const std::string& name : names) row.push_back(own.at(name));
  return row;
}

Row row_of(const Plan& plan, const Run& run, std::uint64_t world_seed, const Driven& driven) {
  return row_in(columns(), plan, run, world_seed, driven.result, {{"mode_errors", std::to_string(driven.errors)}});
}

const std::string& cell(const Row& row, const std::string& column, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), column);
  if (found == names.end()) throw std::logic_error("no column " + column);
  return row.at(static_cast<std::size_t>(found - names.begin()));
}

double value(const Row& row, const std::string& column, const std::vector<std::string>& names) {
  return std::strtod(cell(row, column, names).c_str(), nullptr);
}

std::string to_line(const Row& row) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) line += (i == 0 ? "" : ",") + row[i];
  return line;
}

Row from_line(const std::string& line) { return split(line.substr(0, line.find_first_of("\r\n")), ','); }

std::string path_csv(const drive::DriveResult& result) {
  std::string csv = "t,x,y,theta,v,omega,state\n";
  for (const drive::DriveSample& sample : result.samples) {
    csv += fixed(sample.time, 2) + ',' + fixed(sample.pose.x, 3) + ',' + fixed(sample.pose.y, 3) + ',' +
           fixed(sample.pose.theta, 3) + ',' + fixed(sample.command.v, 3) + ',' + fixed(sample.command.omega, 3) + ',' +
           hidwa_local_planner::to_string(sample.state) + '\n';
  }
  return csv;
}

}  // namespace study
}  // namespace hidwa_local_planner
