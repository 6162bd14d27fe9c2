// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "drive/drive.hpp"

namespace hidwa_local_planner {
namespace drive {

/// Adds up a drive's figures, cycle by cycle.
class Recorder {
 public:
  explicit Recorder(const DriveSetup& setup) : setup_(setup), gentleness_(setup.parameters.acc_lim_theta) {}

  /// One control cycle of `period` [s] that sent `sent`; planning took `spent` [s].
  void add(const Cycle& cycle, const Twist2& sent, double period, double spent);

  /// The figures of the drive, which ended so.
  DriveResult finish(const sim::World& world, Ending ending);

 private:
  void add_command(const Twist2& sent);
  void add_clearance(const sim::Pose& pose);
  void add_steering(const Cycle& cycle, double period);

  const DriveSetup& setup_;
  DriveResult result_;
  Twist2 last_;                 // [m/s, rad/s]
  double v_changes_ = 0.0;      // [m/s], summed up
  double omega_changes_ = 0.0;  // [rad/s]
  double agreements_ = 0.0;
  double clearances_ = 0.0;  // [m]
  GentlenessMeter gentleness_;
  std::size_t steered_ = 0;  // cycles
  bool steering_ = false;
};

}  // namespace drive
}  // namespace hidwa_local_planner
