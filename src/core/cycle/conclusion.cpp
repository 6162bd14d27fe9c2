// SPDX-License-Identifier: BSD-3-Clause
#include "core/cycle/conclusion.hpp"

#include <cmath>

#include "core/motion/late_cycles.hpp"
#include "hidwa_local_planner/core/rest.hpp"

namespace hidwa_local_planner {
namespace {

// Odometry may lag behind a command that brakes already, and must not take that back.
double slower_of(double reference, double last) {
  return reference * last > 0.0 && std::abs(reference) < std::abs(last) ? reference : last;
}

// Both axes towards rest at their limits. After a late cycle it brakes by as much as the time since the cycle before
// allows; otherwise late cycles would add up to a longer way.
Twist2 brake_command(const CycleStart& start) {
  const Twist2 last = start.last_command;
  const Twist2 from{start.limits.x.start_from(slower_of(start.reference.v, last.v), last.v),
                    start.limits.theta.start_from(slower_of(start.reference.omega, last.omega), last.omega)};
  return start.limits.brake(from, late_brake_period(start.elapsed, start.period, start.longest_period));
}

bool stopped(const Cycle& cycle) { return stands(cycle.start.last_command, cycle.start.velocity, cycle.parameters); }

}  // namespace

Conclusion follow(const Twist2& sample, const Twist2& command) {
  Conclusion conclusion;
  conclusion.sample = sample;
  conclusion.command = command;
  conclusion.outcome = commands_rest(command) && commands_rest(sample) ? Outcome::hold : Outcome::drive;
  return conclusion;
}

Conclusion pass_through(const Cycle& cycle) {
  Conclusion conclusion;
  conclusion.sample = cycle.start.limits.clamp(cycle.intent.u_h);
  conclusion.command = cycle.start.limits.step(cycle.start.reference, conclusion.sample, cycle.start.period);
  conclusion.outcome = commands_rest(conclusion.command) ? Outcome::hold : Outcome::drive;
  return conclusion;
}

Conclusion brake(const Cycle& cycle, Problem kind, const char* problem) {
  Conclusion conclusion;
  conclusion.command = brake_command(cycle.start);
  conclusion.problem_kind = kind;
  conclusion.problem = problem;
  if (stopped(cycle)) conclusion.outcome = Outcome::fail;
  return conclusion;
}

void fail_if_stopped(const Cycle& cycle, Problem kind, const char* problem, Conclusion& conclusion) {
  if (!stopped(cycle)) return;
  conclusion.outcome = Outcome::fail;
  conclusion.problem_kind = kind;
  conclusion.problem = problem;
}

Conclusion stop(const Cycle& cycle) {
  Conclusion conclusion = brake(cycle, Problem::none, "");
  conclusion.outcome = commands_rest(conclusion.command) ? Outcome::hold : Outcome::brake;
  return conclusion;
}

const char* unless_off_map(const Cycle& cycle, const char* problem) {
  const Pose2& pose = cycle.start.pose;
  if (cycle.grid.contains(cycle.grid.cell_at(pose.x, pose.y))) return problem;
  return "the robot stands outside of the local costmap: set its rolling_window, or check its size, origin and frame";
}

}  // namespace hidwa_local_planner
