// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace hidwa_local_planner {
namespace drive {

/// How gently autonomy turned. From its commands alone: angular acceleration is the change of omega from the command
/// before, divided by the control period, jerk the change of that, divided by it again. Over the cycles in AUTONOMY,
/// those right after the person let go included.
struct Gentleness {
  double acc_rms = 0.0;        // [rad/s^2]
  double acc_p99 = 0.0;        // [rad/s^2]
  double bend_acc_rms = 0.0;   // [rad/s^2], where |omega| is kBend or more
  double jerk_rms = 0.0;       // [rad/s^3]
  double jerk_p99 = 0.0;       // [rad/s^3]
  double at_limit = 0.0;       // share of the cycles with kAtLimit of the limit or more
  double bend_at_limit = 0.0;  // likewise, of those with |omega| of kBend or more
};

constexpr double kBend = 0.02;     // [rad/s]
constexpr double kAtLimit = 0.95;  // of the limit

/// Adds up a drive's gentleness, cycle by cycle.
class GentlenessMeter {
 public:
  /// `limit` [rad/s^2]: of the robot's angular acceleration.
  explicit GentlenessMeter(double limit) : limit_(limit) {}

  /// One control cycle of `period` [s] that sent `omega` [rad/s].
  void add(bool autonomy, double omega, double period);
  /// Of all cycles so far; all zero where there was none in AUTONOMY.
  Gentleness result() const;

 private:
  double limit_;
  double omega_ = 0.0, acc_ = 0.0;    // of the cycle before
  std::vector<double> accs_, jerks_;  // of each cycle in AUTONOMY, without their signs
  std::vector<double> bend_accs_;     // likewise, in bends
};

}  // namespace drive
}  // namespace hidwa_local_planner
