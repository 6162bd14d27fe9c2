// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/diagnostics.hpp"

namespace hidwa_local_planner {

Diagnostics::Diagnostics(ros::NodeHandle handle, const std::string& name, const CycleStatistics& statistics,
                         const OperatorInput& person)
    : statistics_(statistics), person_(person), updater_(handle, ros::NodeHandle("~")) {
  updater_.setHardwareID("none");
  updater_.add(name, [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report(status); });
  timer_ = handle.createWallTimer(ros::WallDuration(1.0),
                                  [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void Diagnostics::set(const std::string& fault, const Load& load) {
  std::shared_ptr<const std::string> other;
  if (fault != known_fault_) {
    known_fault_ = fault;
    other = std::make_shared<const std::string>(fault);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  load_ = load;
  if (other) fault_.swap(other);
}

void Diagnostics::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using Status = diagnostic_msgs::DiagnosticStatus;
  const CycleStatistics::Summary cycles = statistics_.summary();
  const OperatorInput::Status person = person_.status(ros::Time::now().toSec());
  const std::string advice = person_.advice();
  std::shared_ptr<const std::string> fault;
  Load load;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    fault = fault_;
    load = load_;
  }
  status.summary(Status::OK, "ready");
  if (!advice.empty()) status.mergeSummary(Status::WARN, advice);
  const std::string thinned = thinning_complaint(load.in_force, load.full, load.budget);
  if (!thinned.empty()) status.mergeSummary(Status::WARN, thinned);
  if (cycles.p99 > load.period) {
    status.mergeSummary(Status::WARN,
                        "cycles take longer than the control period: lower vx_samples or vth_samples");
  }
  const bool idle = cycles.cycles == reported_cycles_;  // what was missing in the last cycle is old
  if (!fault->empty() && !idle) status.mergeSummary(Status::ERROR, *fault);
  reported_cycles_ = cycles.cycles;
  status.add("cycles", cycles.cycles);
  status.add("cycles longer than the period", cycles.late);
  status.add("cycle time p50 [ms]", 1e3 * cycles.p50);
  status.add("cycle time p99 [ms]", 1e3 * cycles.p99);
  status.add("cycle time max [ms]", 1e3 * cycles.max);
  report_load(status, load);
  status.add("operator", to_string(person.state));
  status.add("operator input age [s]", person.age);
  status.add("operator messages dropped", person.dropped);
}

void Diagnostics::report_load(diagnostic_updater::DiagnosticStatusWrapper& status, const Load& load) const {
  status.add("control period [ms]", 1e3 * load.period);
  if (load.budget >= 0.0) {
    status.add("cycle budget [ms]", 1e3 * load.budget);
  } else {
    status.add("cycle budget [ms]", "none");
  }
  status.add("vx_samples in force", load.in_force.vx_samples);
  status.add("vth_samples in force", load.in_force.vth_samples);
}

}  // namespace hidwa_local_planner
