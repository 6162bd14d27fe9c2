// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/motion/pending_motion_set.hpp"
#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/core/rest.hpp"

namespace hidwa_local_planner {

/// What a cycle starts from. StartEstimator finds it.
struct CycleStart {
  Twist2 reference;                           // the velocity that a command starts from [m/s, rad/s]
  const VelocityLimits* limits = nullptr;     // of this cycle's commands
  Twist2 velocity;                            // what is believed of the measured one [m/s, rad/s]
  bool odometry_doubted = false;              // the commands do not explain a reading, and it is not believed
  bool odometry_fast = false;                 // it is faster than they explain, and is believed
  Twist2 last_command;                        // zero before the first cycle [m/s, rad/s]
  double elapsed = 0.0;                       // since the cycle before; 0 where there is none [s]
  Pose2 origin;                               // the pose as it was measured: where `pending` begins, costmap frame
  const PendingMotionSet* pending = nullptr;  // until this cycle's command takes effect
  const Situation* situation = nullptr;       // as measured, but with the pose of now
};

/// The robot moves, or the last command will move it although odometry does not show it yet.
inline bool moves(const CycleStart& start, const Parameters& parameters) {
  return !stands(start.last_command, start.velocity, parameters);
}

/// The control period, or the default one where it cannot be one; the time and the pose's age, or 0 where they cannot
/// be any [s]. The cycle brakes there, since its input has a fault.
double usable_period(const Situation& situation);
double usable_time(const Situation& situation);
double usable_age(const Situation& situation);
/// The longest control period of the last seconds [s].
double longest_period(const Situation& situation);

/// The command that brakes from here: both axes towards rest at their limits. After a late cycle it brakes by as much
/// as the time since the cycle before allows; otherwise late cycles would add up to a longer way.
Twist2 brake_command(const CycleStart& start, const VelocityLimits& limits, const Situation& situation);

}  // namespace hidwa_local_planner
