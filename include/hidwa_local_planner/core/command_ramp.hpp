// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/velocity_limits.hpp"

namespace hidwa_local_planner {

/// How a command is reached from another velocity within a period, each axis on its own: where it speeds up, at the limit
/// and then no further; where it slows down, evenly over the period. No base that keeps the limits drives farther.
class CommandRamp {
 public:
  CommandRamp(const VelocityLimits& limits, const Twist2& from, const Twist2& to, double period)
      : period_(period),
        from_(from),
        to_(to),
        v_(time(limits.x, from.v, to.v, period)),
        omega_(time(limits.theta, from.omega, to.omega, period)),
        corners_{std::min(v_, omega_), std::max(v_, omega_), period} {}

  /// Until when the velocity changes evenly [s], in order; the last is the period.
  const std::array<double, 3>& corners() const { return corners_; }
  /// The velocity at a corner.
  Twist2 at(double corner) const {
    return {part(from_.v, to_.v, corner, v_), part(from_.omega, to_.omega, corner, omega_)};
  }
  /// How far at most a point `radius` [m] from the centre gets beyond where it would be, were all of it done evenly [m].
  double ahead(double radius) const {
    return 0.5 * (std::abs(to_.v - from_.v) * (period_ - v_) +
                  radius * std::abs(to_.omega - from_.omega) * (period_ - omega_));
  }

 private:
  static double time(const AxisLimits& axis, double from, double to, double period) {
    constexpr double kRounding = 1e-9;  // [s]
    const bool turns_round = from * to < 0.0;
    if (!turns_round && std::abs(to) <= std::abs(from)) return period;
    const double needed = turns_round ? std::abs(from) / axis.braking + std::abs(to) / axis.acc
                                      : std::abs(to - from) / axis.acc;
    return needed < period - kRounding ? needed : period;
  }
  static double part(double from, double to, double t, double time) {
    return t < time ? from + t / time * (to - from) : to;
  }

  double period_;  // [s]
  Twist2 from_, to_;
  double v_, omega_;  // when each of them is reached [s]
  std::array<double, 3> corners_;
};

}  // namespace hidwa_local_planner
