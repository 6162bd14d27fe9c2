// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// One axis of velocity. Accelerating is growing away from 0, braking is going towards it, whichever the direction.
struct AxisLimits {
  double min = 0.0;      // [unit/s]
  double max = 0.0;      // [unit/s]
  double acc = 0.0;      // > 0 [unit/s^2]
  double braking = 0.0;  // > 0 [unit/s^2]

  double clamp(double velocity) const;
  /// The largest speed, in either direction.
  double fastest() const { return max > -min ? max : -min; }
  /// A velocity that a command may start from: in magnitude no larger than the limit or the last command. So no command
  /// exceeds the larger of the limit and the last command reduced at the braking limit.
  double start_from(double velocity, double last_command) const;
  /// The velocity after `dt` [s] on the way from `velocity` to `target`, which it never passes.
  double ramp(double velocity, double target, double dt) const;
  /// Time to come to rest from `velocity` [s].
  double time_to_rest(double velocity) const;
  /// How far it moves on until it rests.
  double distance_to_rest(double velocity) const;
};

struct Interval {
  double lo = 0.0;
  double hi = 0.0;
};

/// What is reachable within `dt` [s]. A velocity outside the limits is brought back at the braking limit: the interval
/// then is the reachable end nearest to the limits, never empty.
Interval reachable(const AxisLimits& axis, double velocity, double dt);

/// The limits of a differential drive: two axes, and the wheels that cut the corners of the window.
struct VelocityLimits {
  AxisLimits x;
  AxisLimits theta;
  double half_separation = 0.0;  // [m]
  double wheel_speed = 0.0;      // r * w_max [m/s]; 0: no wheel limit

  static VelocityLimits from(const Parameters& parameters);

  bool wheels_allow(const Twist2& u) const;
  /// A velocity brought inside: each axis to its limits; where the wheels cut it, omega is kept and v reduced.
  Twist2 clamp(const Twist2& velocity) const;
  /// The command of this period: `target` as far as `reference` can move towards it in `dt` [s], wheels included.
  Twist2 step(const Twist2& reference, const Twist2& target, double dt) const;
  /// The brake command: both axes towards rest at their limits.
  Twist2 brake(const Twist2& reference, double dt) const { return step(reference, Twist2{}, dt); }
};

}  // namespace hidwa_local_planner
