// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/motion/brake_manoeuvre.hpp"
#include "core/motion/late_cycles.hpp"
#include "core/motion/pending_motion_set.hpp"
#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Where the robot is when a command takes effect.
struct CommandStart {
  TurnedPose at;       // costmap frame
  Twist2 velocity;     // [m/s, rad/s]
  double delay = 0.0;  // until then [s]
};

/// What a cycle starts from. StartEstimator finds it once, and nobody changes it.
struct CycleStart {
  Pose2 pose;                                 // of the robot now, costmap frame
  Pose2 origin;                               // the pose as it was measured: where `pending` begins, costmap frame
  Twist2 reference;                           // the velocity that a command starts from [m/s, rad/s]
  Twist2 velocity;                            // what is believed of the measured one [m/s, rad/s]
  Twist2 last_command;                        // zero before the first cycle [m/s, rad/s]
  VelocityLimits limits;                      // of this cycle's commands
  const PendingMotionSet* pending = nullptr;  // until this cycle's command takes effect
  double period = 0.05;                       // of the control cycle; the default one where the given one is none [s]
  double longest_period = 0.05;               // the next command comes no later [s]
  double elapsed = 0.0;                       // since the cycle before; 0 where there is none [s]
  bool odometry_doubted = false;              // the commands do not explain a reading, and it is not believed
  bool odometry_fast = false;                 // it is faster than they explain, and is believed

  /// How much later than one period after a command the first command to brake may take effect [s].
  double latest_hold() const { return hidwa_local_planner::latest_hold(period, longest_period); }
  /// What the robot does after the pending motion of this number, a command [m/s, rad/s], and one to brake that takes
  /// effect `hold` [s] later than one period after it.
  BrakeManoeuvre manoeuvre(std::size_t motion, const Twist2& command, double hold) const {
    return {origin, (*pending)[motion], command, period, hold};
  }
  /// What a manoeuvre's drift, and its growth, come to at most [m], for a robot with this radius [m] whose centre gets
  /// no farther than `reach` [m]; see ManoeuvreRoller.
  double most_drift(double radius, double reach) const {
    // One ramp and one tail: no way to them is farther off than half of what the limits allow in a period.
    const auto of_command = [this](const AxisLimits& axis) {
      return 0.75 * std::max(axis.acc, axis.braking) * period * period;
    };
    Twist2 spread;
    for (std::size_t i = 0; i < pending->all(); ++i) spread = larger_of(spread, (*pending)[i].spread());
    return spread.v + of_command(limits.x) + (radius + reach) * (spread.omega + of_command(limits.theta));
  }
  /// By the likeliest pending motion. `radius` [m] reaches from the robot's centre to its farthest point.
  CommandStart command_start(double radius) const {
    constexpr double kAnyDistance = 1e3;   // [m]
    constexpr double kLongestStep = 0.05;  // [s]
    const PendingMotion& likeliest = (*pending)[pending->likely() - 1];
    ManoeuvreRoller roller(limits, radius, kAnyDistance, {origin, Rotation::of(origin.theta)}, kLongestStep);
    roller.roll_on(likeliest, [](const TurnedPose&) { return true; });
    return {roller.at(), likeliest.end(), std::max(0.0, roller.time())};
  }
};

}  // namespace hidwa_local_planner
