// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "braking.hpp"
#include "spec.hpp"

namespace hidwa_attack {

/// Watches the bound on commands: on each axis, in either direction, at most the larger of the limit in force and the
/// last command reduced at the deceleration limit.
class CommandWatch {
 public:
  void observe(const Parameters& in_force, double period, const Twist2& last, const Twist2& command) {
    const double x = period * braking_x(in_force);
    const double theta = period * braking_theta(in_force);
    const double v =
        std::max(over(in_force.max_vel_x, last.v, x, command.v), over(-in_force.min_vel_x, -last.v, x, -command.v));
    const double omega = std::max(over(in_force.max_vel_theta, last.omega, theta, command.omega),
                                  over(in_force.max_vel_theta, -last.omega, theta, -command.omega));
    if (v > kRounding || omega > kRounding) ++count_;
    worst_.v = std::max(worst_.v, v);
    worst_.omega = std::max(worst_.omega, omega);
  }
  /// A command differs from the last one by no more than the larger acceleration limit allows within the longest recent
  /// period [s]. The paper's method starts from odometry: the difference counts from the interval that holds the last
  /// command, the reading, and what may replace a doubted reading (`other`).
  void judge_acceleration(const Parameters& in_force, double longest, const Twist2& last, const Twist2& reading,
                          const Twist2& other, const Twist2& command) {
    const double x = longest * std::max(in_force.acc_lim_x, braking_x(in_force));
    const double theta = longest * std::max(in_force.acc_lim_theta, braking_theta(in_force));
    const bool reads = in_force.method == hidwa_local_planner::Method::paper;
    const Twist2 a = reads ? reading : last, b = reads ? other : last;
    if (outside(command.v, {last.v, a.v, b.v}) > x + kRounding ||
        outside(command.omega, {last.omega, a.omega, b.omega}) > theta + kRounding)
      ++hard_;
  }
  int count() const { return count_; }            // of commands beyond the bound
  int hard() const { return hard_; }              // of commands that ask for more than the larger acceleration limit
  const Twist2& worst() const { return worst_; }  // how far beyond it [m/s, rad/s]

 private:
  static constexpr double kRounding = 1e-6;
  // How far a value is from what lies between others.
  static double outside(double value, std::initializer_list<double> others) {
    return std::max({std::min(others) - value, value - std::max(others), 0.0});
  }
  static double over(double limit, double last, double step, double command) {
    return command - std::max({limit, last - step, 0.0});
  }

  int count_ = 0, hard_ = 0;
  Twist2 worst_;
};

}  // namespace hidwa_attack
