// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/planner.hpp"
#include "sim/diff_drive.hpp"

namespace hidwa_local_planner::test {

/// A base is sent the decision's command (zero where it failed) and moves for one control period in `steps` steps;
/// `seen` is called after each of them, with its number from 0. Time, pose and last command of `now` go on with it.
template <typename Seen>
void drive_on(Situation& now, sim::DiffDrive& base, const Decision& decision, int steps, Seen&& seen) {
  const Twist2 command = decision.outcome == Outcome::fail ? Twist2{} : decision.command;
  base.command({command.v, command.omega}, now.time);
  for (int k = 0; k < steps; ++k) {
    const double step = now.period / steps;
    const sim::Pose next = sim::moved({now.pose.x, now.pose.y, now.pose.theta}, base.step(now.time + k * step, step));
    now.pose = {next.x, next.y, next.theta};
    seen(k);
  }
  now.last_command = command;
  now.time += now.period;
}

}  // namespace hidwa_local_planner::test
