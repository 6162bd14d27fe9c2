// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/velocity_limits.hpp"

namespace hidwa_local_planner {

/// What happens when a command is sent and the next one already brakes: the reference velocity for the latency, one
/// period's ramp to the command, then both axes at their braking limits until rest.
struct BrakeManoeuvre {
  Pose2 start;           // costmap frame
  Twist2 reference;      // [m/s, rad/s]
  Twist2 command;        // [m/s, rad/s]
  double latency = 0.0;  // [s]
  double period = 0.05;  // [s]
};

/// The poses of a manoeuvre after its start, the last one at rest. No point within `radius` [m] of the robot's centre
/// moves more than `spacing` [m] between two of them. Empty when it does not move at all.
void roll_out(const BrakeManoeuvre& manoeuvre, const VelocityLimits& limits, double radius, double spacing,
              std::vector<Pose2>& poses);

}  // namespace hidwa_local_planner
