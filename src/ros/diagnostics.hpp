// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include "control/sample_budget.hpp"
#include "ros/cycle_statistics.hpp"
#include "ros/moving_obstacle_input.hpp"
#include "ros/operator_input.hpp"

namespace hidwa_local_planner {

/// Once a second on /diagnostics, from the handle's callback thread: cycle times, samples, the operator, what
/// is missing. The control thread never waits for a report: the lock is held to copy numbers and two short texts.
class Diagnostics {
 public:
  /// The operator and the moving obstacles must outlive it.
  Diagnostics(ros::NodeHandle handle, const std::string& name, const OperatorInput& person,
              const MovingObstacleInput& moving_obstacles);
  /// How the cycles are doing.
  struct Load {
    double period = 0.0;             // of the control cycle [s]
    double longest_period = 0.0;     // of late: what the check for braking reckons with [s]
    std::uint64_t doubted = 0;       // readings of odometry that no command explains
    std::optional<double> answered;  // the latency that the base shows [s]
    double control_latency = 0.0;    // what was told [s]
    double budget = 0.0;             // [s]; negative: none
    Sampling in_force;
    Sampling full;
  };
  /// From the control thread, once a cycle: it took `duration` of its `period` [s].
  void add(double duration, double period);
  /// From the control thread, once a cycle. `fault`: what is missing at present; `odometry`: what is odd about the
  /// odometry. Each is empty when nothing is.
  void set(const std::string& fault, const std::string& odometry, const Load& load);

 private:
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);
  void report_person(diagnostic_updater::DiagnosticStatusWrapper& status);
  void report_moving_obstacles(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void report_load(diagnostic_updater::DiagnosticStatusWrapper& status, const Load& load) const;

  const OperatorInput& person_;
  const MovingObstacleInput& moving_obstacles_;
  std::mutex mutex_;
  CycleStatistics statistics_;
  std::string fault_, odometry_;
  Load load_;
  std::uint64_t reported_cycles_ = 0;
  std::uint64_t reported_messages_ = 0;
  ros::WallTime reported_at_;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace hidwa_local_planner
