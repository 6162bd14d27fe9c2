// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <mutex>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include "hidwa_local_planner/ros/cycle_statistics.hpp"
#include "hidwa_local_planner/ros/operator_input.hpp"

namespace hidwa_local_planner {

/// Once a second on /diagnostics, from the handle's callback thread: cycle times, the operator, what is
/// missing.
class Diagnostics {
 public:
  /// The statistics and the operator must outlive it.
  Diagnostics(ros::NodeHandle handle, const std::string& name, const CycleStatistics& statistics,
              const OperatorInput& person);
  /// What is missing at present; empty when nothing is.
  void set_fault(const std::string& fault);
  void set_period(double period);  // [s]

 private:
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  const CycleStatistics& statistics_;
  const OperatorInput& person_;
  std::mutex mutex_;
  std::string fault_;
  double period_ = 0.05;  // [s]
  std::uint64_t reported_cycles_ = 0;
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace hidwa_local_planner
