// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "spec.hpp"

namespace hidwa_attack {

/// Watches the bound on commands: on each axis, in either direction, at most the larger of the limit in force and the
/// last command reduced at the deceleration limit. Beside it, how far it may be from the last command within a period.
class CommandWatch {
 public:
  void observe(const Parameters& in_force, double period, const Twist2& last, const Twist2& command) {
    const double x = period * braking(in_force.decel_lim_x, in_force.acc_lim_x);
    const double theta = period * braking(in_force.decel_lim_theta, in_force.acc_lim_theta);
    const double v =
        std::max(over(in_force.max_vel_x, last.v, x, command.v), over(-in_force.min_vel_x, -last.v, x, -command.v));
    const double omega = std::max(over(in_force.max_vel_theta, last.omega, theta, command.omega),
                                  over(in_force.max_vel_theta, -last.omega, theta, -command.omega));
    if (v > kRounding || omega > kRounding) ++count_;
    const double gain_x = period * std::max(in_force.acc_lim_x, braking(in_force.decel_lim_x, in_force.acc_lim_x));
    const double gain_theta =
        period * std::max(in_force.acc_lim_theta, braking(in_force.decel_lim_theta, in_force.acc_lim_theta));
    if (std::abs(command.v - last.v) > gain_x + kRounding ||
        std::abs(command.omega - last.omega) > gain_theta + kRounding)
      ++hard_;
    worst_.v = std::max(worst_.v, v);
    worst_.omega = std::max(worst_.omega, omega);
  }
  int count() const { return count_; }            // of commands beyond the bound
  int hard() const { return hard_; }              // of commands that ask for more than the larger acceleration limit
  const Twist2& worst() const { return worst_; }  // how far beyond it [m/s, rad/s]

 private:
  static constexpr double kRounding = 1e-6;
  static double braking(double told, double acc) { return told != 0.0 ? std::abs(told) : acc; }
  static double over(double limit, double last, double step, double command) {
    return command - std::max({limit, last - step, 0.0});
  }

  int count_ = 0, hard_ = 0;
  Twist2 worst_;
};

}  // namespace hidwa_attack
