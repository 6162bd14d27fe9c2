// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace sim {

/// Velocity of a differential drive in its own frame.
struct Velocity {
  double v = 0.0;      // [m/s], forward
  double omega = 0.0;  // [rad/s], left
};

/// What the base can do.
struct DriveLimits {
  double max_vel_x = 0.5;         // [m/s], either way
  double max_vel_theta = 1.0;     // [rad/s]
  double acc_lim_x = 2.5;         // [m/s2], speeding up
  double acc_lim_theta = 3.2;     // [rad/s2]
  double decel_lim_x = 2.5;       // [m/s2], slowing down
  double decel_lim_theta = 3.2;   // [rad/s2]
  double wheel_separation = 0.0;  // [m]
  double max_wheel_speed = 0.0;   // [m/s], of its rim; 0: no wheel limit
  double latency = 0.0;           // [s], from a command's arrival to its effect
  double command_timeout = 0.5;   // [s], without a command the base brakes to rest; 0: never
};

/// Throws std::invalid_argument naming the first limit that makes no sense.
void check(const DriveLimits& limits);

/// What one step moved, along the arc driven.
struct Motion {
  double distance = 0.0;  // [m]
  double angle = 0.0;     // [rad]
};

/// Pose after `motion` along a circular arc from `pose` (exact for constant curvature).
Pose moved(const Pose& pose, const Motion& motion);

/// A differential drive that ramps to its last effective command under its acceleration limits.
class DiffDrive {
 public:
  explicit DiffDrive(const DriveLimits& limits);

  /// A command that arrives at time `now` [s]; values that are not finite count as zero.
  void command(const Velocity& velocity, double now);

  /// Advances from time `now` by `dt` [s]; commands take effect at the start of a step.
  Motion step(double now, double dt);

  /// What stops an axis from outside, an obstacle for example.
  void set_velocity(const Velocity& velocity) { velocity_ = velocity; }

  const Velocity& velocity() const { return velocity_; }
  const Velocity& target() const { return target_; }
  const DriveLimits& limits() const { return limits_; }

 private:
  struct Timed {
    double effective;  // [s]
    Velocity velocity;
  };

  Velocity limited(Velocity velocity) const;
  void take_effect(double now);

  DriveLimits limits_;
  Velocity velocity_;
  Velocity target_;
  std::deque<Timed> pending_;
  double last_effect_ = 0.0;  // [s], when target_ took effect
};

/// Ramps `speed` towards `target` for `dt` [s], at `deceleration` while its magnitude falls, else at
/// `acceleration`. Returns the integral of the speed over dt.
double ramp(double& speed, double target, double acceleration, double deceleration, double dt);

}  // namespace sim
}  // namespace hidwa_local_planner
