// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/cycle/cycle.hpp"
#include "hidwa_local_planner/core/decision.hpp"

namespace hidwa_local_planner {

/// What a cycle comes to.
struct Conclusion {
  Outcome outcome = Outcome::brake;
  Twist2 command;  // to send [m/s, rad/s]
  Twist2 sample;   // of the chosen candidate, zero where there is none [m/s, rad/s]
  Problem problem_kind = Problem::none;
  const char* problem = "";  // in words; lives as long as the planner
};

/// The robot follows a candidate: `command` is the first step towards its sample.
Conclusion follow(const Twist2& sample, const Twist2& command);
/// The operator command is passed through unchecked, within the limits.
Conclusion pass_through(const Cycle& cycle);
/// The robot brakes, since it has no candidate to follow. A robot that stands fails instead.
Conclusion brake(const Cycle& cycle, Problem kind, const char* problem);
/// Returns `problem`. If the robot's centre is off the map, where everything is an obstacle, returns that problem
/// instead.
const char* unless_off_map(const Cycle& cycle, const char* problem);
/// The cycle of a robot that stands fails, and the host replans or recovers: it sends zero at once, whatever the robot
/// did. So no cycle of a robot that moves fails: its conclusion stays as it is. Nothing else in the planner but brake()
/// makes a cycle fail.
void fail_if_stopped(const Cycle& cycle, Problem kind, const char* problem, Conclusion& conclusion);
/// The operator or the host stops the robot: it brakes, then holds.
Conclusion stop(const Cycle& cycle);

}  // namespace hidwa_local_planner
