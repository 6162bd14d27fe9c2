// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// How fast a robot may go that stands in collision: it stops within half a cell. A command (v, omega) that is sent now
/// and braked in the next cycle moves the outline's farthest point by at most
///   way(v, omega) = (|v| + R |omega|) (control_latency + period) + v^2 / (2 b_x) + R omega^2 / (2 b_theta)   [m]
/// with the braking limits b and the distance R from the centre to that point; R = 0 for a circle, which covers the
/// same ground however it turns. way <= half a cell. Straight on with 0.1 s, 0.05 s, 2.5 m/s^2 and cells of 0.05 m:
///   0.15 v + 0.2 v^2 = 0.025, so v = 0.140 m/s.
class EscapeSpeed {
 public:
  EscapeSpeed() = default;
  /// `arm` [m] is R, `delay` [s] control_latency and a period.
  EscapeSpeed(const VelocityLimits& limits, double arm, double resolution, double delay)
      : limits_(limits), arm_(arm), room_(0.5 * resolution), delay_(delay) {}

  double arm() const { return arm_; }  // [m]
  /// How far the outline's farthest point moves until rest, at most [m].
  double way(const Twist2& u) const {
    return (std::abs(u.v) + arm_ * std::abs(u.omega)) * delay_ + limits_.x.distance_to_rest(u.v) +
           arm_ * limits_.theta.distance_to_rest(u.omega);
  }
  /// A robot that is faster already brakes as hard as it can.
  bool allows(const Twist2& u, const Twist2& reference, double period) const {
    constexpr double kRounding = 1e-9;  // [m, m/s, rad/s]
    if (way(u) <= room_ + kRounding) return true;
    const Twist2 braked = limits_.brake(reference, period);
    return std::abs(u.v) <= std::abs(braked.v) + kRounding && std::abs(u.omega) <= std::abs(braked.omega) + kRounding;
  }
  /// The limits with both axes slowed down to what each of them may have alone.
  VelocityLimits slowed() const {
    VelocityLimits slow = limits_;
    slow_down(slow.x, fastest(room_, limits_.x.braking));
    if (arm_ > 0.0) slow_down(slow.theta, fastest(room_ / arm_, limits_.theta.braking));
    return slow;
  }

 private:
  // The speed that comes to rest after `way`: speed * delay + speed^2 / (2 braking) = way.
  double fastest(double way, double braking) const {
    const double lost = braking * delay_;
    return std::sqrt(lost * lost + 2.0 * braking * way) - lost;
  }
  static void slow_down(AxisLimits& axis, double most) {
    axis.min = std::max(axis.min, -most);
    axis.max = std::min(axis.max, most);
  }

  VelocityLimits limits_;
  double arm_ = 0.0;    // [m]
  double room_ = 0.0;   // [m]
  double delay_ = 0.0;  // [s]
};

}  // namespace hidwa_local_planner
