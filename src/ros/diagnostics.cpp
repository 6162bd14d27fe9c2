// SPDX-License-Identifier: BSD-3-Clause
#include "ros/diagnostics.hpp"

#include "control/response_watch.hpp"
#include "ros/operator_feedback.hpp"

namespace hidwa_local_planner {

Diagnostics::Diagnostics(ros::NodeHandle handle, const std::string& name, const OperatorInput& person,
                         const MovingObstacleInput& moving_obstacles)
    : person_(person), moving_obstacles_(moving_obstacles), updater_(handle, ros::NodeHandle("~")) {
  updater_.setHardwareID("none");
  updater_.add(name, [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report(status); });
  updater_.add(name + " operator",
               [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report_person(status); });
  updater_.add(name + " moving obstacles",
               [this](diagnostic_updater::DiagnosticStatusWrapper& status) { report_moving_obstacles(status); });
  timer_ =
      handle.createWallTimer(ros::WallDuration(1.0), [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void Diagnostics::add(double duration, double period) {
  const std::lock_guard<std::mutex> lock(mutex_);
  statistics_.add(duration, period);
}

// A text as long as the one before takes no other memory.
void Diagnostics::set(const std::string& fault, const std::string& odometry, const Load& load) {
  const std::lock_guard<std::mutex> lock(mutex_);
  load_ = load;
  fault_ = fault;
  odometry_ = odometry;
}

void Diagnostics::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using Status = diagnostic_msgs::DiagnosticStatus;
  CycleStatistics statistics;
  std::string fault, odometry;
  Load load;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    statistics = statistics_;
    fault = fault_;
    odometry = odometry_;
    load = load_;
  }
  const CycleStatistics::Summary cycles = statistics.summary();
  status.summary(Status::OK, "ready");
  const std::string thinned = thinning_complaint(load.in_force, load.full, load.budget);
  if (!thinned.empty()) status.mergeSummary(Status::WARN, thinned);
  if (!odometry.empty()) status.mergeSummary(Status::WARN, odometry);
  if (cycles.p99 > load.period) {
    status.mergeSummary(Status::WARN, "cycles take longer than the control period: lower vx_samples or vth_samples");
  }
  const std::string late =
      load.answered ? latency_complaint(*load.answered, load.control_latency, load.period) : std::string();
  if (!late.empty()) status.mergeSummary(Status::WARN, late);
  const bool idle = cycles.cycles == reported_cycles_;  // what was missing in the last cycle is old
  if (!fault.empty() && !idle) status.mergeSummary(Status::ERROR, fault);
  reported_cycles_ = cycles.cycles;
  status.add("cycles", cycles.cycles);
  status.add("cycles longer than the period", cycles.late);
  status.add("cycle time p50 [ms]", 1e3 * cycles.p50);
  status.add("cycle time p99 [ms]", 1e3 * cycles.p99);
  status.add("cycle time max [ms]", 1e3 * cycles.max);
  report_load(status, load);
}

void Diagnostics::report_person(diagnostic_updater::DiagnosticStatusWrapper& status) {
  using Status = diagnostic_msgs::DiagnosticStatus;
  const OperatorInput::Status person = person_.status(LoopTime::now().seconds);
  const OperatorInput::Device device = person_.device();
  const std::string advice = person_.advice();
  const ros::WallTime now = ros::WallTime::now();
  const double elapsed = (now - reported_at_).toSec();
  const std::uint64_t since = device.messages >= reported_messages_ ? device.messages - reported_messages_ : 0;
  const double rate = !reported_at_.isZero() && elapsed > 0.0 ? static_cast<double>(since) / elapsed : 0.0;
  reported_at_ = now;
  reported_messages_ = device.messages;

  const bool without_goal = person.state == OperatorStateId::manual && person.goalless;
  const std::string state = std::string(to_string(person.state)) + (without_goal ? ", without a goal" : "");
  status.summary(Status::OK, state);
  if (person.mode == OperatorMode::off) {
    const std::string off = "off: nobody steers (parameter mode, or the topic set_mode)";
    status.summary(Status::OK, person.state == OperatorStateId::stopped ? "STOPPED; " + off : off);
  } else if (device.messages == 0) {
    // Nothing wrong: autonomy drives. (Merging would drop the words of what is well.)
    status.summary(Status::OK, "nothing came on " + device.topic + " yet: start the device's node, or set mode off");
  } else if (!device.clutch_topic.empty() && device.clutch_messages == 0) {
    status.summary(Status::OK, "nothing came on " + device.clutch_topic +
                                   " yet: the hand steers only while the clutch, a button or axis there, is held");
  } else if (person.state == OperatorStateId::lost && person.lost_by_pauses) {
    status.mergeSummary(Status::ERROR, device.topic +
                                           " was not heard, since the planner itself stood still: lighten "
                                           "its machine's load; nothing is known against the link");
  } else if (person.state == OperatorStateId::lost) {
    status.mergeSummary(Status::ERROR,
                        device.topic + " fell silent while the operator steered: check the link to " + device.sender);
  }
  if (!advice.empty()) status.mergeSummary(Status::WARN, advice);
  status.add("mode", name_of(person.mode));
  status.add("state", state);
  status.add("input", device.topic);
  status.add("device", device.sender.empty() ? "none yet" : device.sender);
  status.add("rate [Hz]", rate);
  status.add("age of the last message [s]", person.age);
  status.add("messages", device.messages);
  status.add("messages dropped", person.dropped);
}

void Diagnostics::report_moving_obstacles(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using Status = diagnostic_msgs::DiagnosticStatus;
  const MovingObstacleInput::Status known = moving_obstacles_.status();
  if (known.topic.empty()) {
    status.summary(Status::OK, "off: moving_obstacles_topic is empty, every obstacle counts as standing still");
  } else if (known.messages == 0) {
    status.summary(Status::OK, "nothing came on " + known.topic + " yet: every obstacle counts as standing still");
  } else if (!known.fault.empty()) {
    status.summary(Status::WARN, known.topic + ": " + known.fault);
  } else {
    status.summary(Status::OK, known.topic + " is heard");
  }
  status.add("moving obstacles", known.count);
  status.add("age of the newest message [s]", known.age);
  status.add("messages", known.messages);
  status.add("obstacles refused", known.refused);
  status.add("sensor sectors told", known.sectors);
}

void Diagnostics::report_load(diagnostic_updater::DiagnosticStatusWrapper& status, const Load& load) const {
  status.add("control period [ms]", 1e3 * load.period);
  status.add("control period in force for braking [ms]", 1e3 * load.longest_period);
  status.add("odometry readings doubted", load.doubted);
  if (load.answered) {
    status.add("latency of the base, at least [s]", *load.answered);
  } else {
    status.add("latency of the base, at least [s]", "not known yet");
  }
  if (load.budget >= 0.0) {
    status.add("cycle budget [ms]", 1e3 * load.budget);
  } else {
    status.add("cycle budget [ms]", "none");
  }
  status.add("vx_samples in force", load.in_force.vx_samples);
  status.add("vth_samples in force", load.in_force.vth_samples);
}

}  // namespace hidwa_local_planner
