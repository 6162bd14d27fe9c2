// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/planner.hpp"
#include "sim/diff_drive.hpp"

namespace hidwa_local_planner::test {

/// A base is sent a command and moves `pose` for one control period [s] in `steps` steps; `seen` is called after each
/// of them, with its number from 0.
template <typename Seen>
void drive_on(Pose2& pose, sim::DiffDrive& base, const Twist2& command, double now, double period, int steps,
              Seen&& seen) {
  base.command({command.v, command.omega}, now);
  for (int k = 0; k < steps; ++k) {
    const double step = period / steps;
    const sim::Pose next = sim::moved({pose.x, pose.y, pose.theta}, base.step(now + k * step, step));
    pose = {next.x, next.y, next.theta};
    seen(k);
  }
}

/// Likewise. Time, pose and last command of `now` go on with it.
template <typename Seen>
void drive_on(Situation& now, sim::DiffDrive& base, const Twist2& command, int steps, Seen&& seen) {
  drive_on(now.pose, base, command, now.time, now.period, steps, seen);
  now.last_command = command;
  now.time += now.period;
}

}  // namespace hidwa_local_planner::test
