// SPDX-License-Identifier: BSD-3-Clause
#include "core/cycle/conclusion.hpp"

namespace hidwa_local_planner {

Conclusion follow(const Twist2& sample, const Twist2& command) {
  Conclusion conclusion;
  conclusion.sample = sample;
  conclusion.command = command;
  conclusion.outcome = commands_rest(command) && commands_rest(sample) ? Outcome::hold : Outcome::drive;
  return conclusion;
}

Conclusion pass_through(const Cycle& cycle) {
  Conclusion conclusion;
  conclusion.sample = cycle.limits.clamp(cycle.intent.u_h);
  conclusion.command = cycle.limits.step(cycle.start.reference, conclusion.sample, cycle.situation.period);
  conclusion.outcome = commands_rest(conclusion.command) ? Outcome::hold : Outcome::drive;
  return conclusion;
}

Conclusion brake(const Cycle& cycle, Problem kind, const char* problem) {
  Conclusion conclusion;
  conclusion.command = brake_command(cycle.start, cycle.limits, cycle.situation);
  conclusion.problem_kind = kind;
  conclusion.problem = problem;
  fail(cycle, kind, problem, conclusion);
  return conclusion;
}

void fail(const Cycle& cycle, Problem kind, const char* problem, Conclusion& conclusion) {
  if (moves(cycle.start, cycle.parameters)) return;
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
  const Pose2& pose = cycle.situation.pose;
  if (cycle.grid.contains(cycle.grid.cell_at(pose.x, pose.y))) return problem;
  return "the robot stands outside of the local costmap: set its rolling_window, or check its size, origin and frame";
}

}  // namespace hidwa_local_planner
