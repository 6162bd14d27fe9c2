// SPDX-License-Identifier: BSD-3-Clause
#include "control/goal_checker.hpp"

#include <algorithm>
#include <cmath>

#include "control/pause.hpp"
#include "hidwa_local_planner/core/rest.hpp"

namespace hidwa_local_planner {

double goal_margin(const Parameters& parameters) { return std::clamp(parameters.xy_goal_tolerance, 0.05, 0.25); }

bool GoalChecker::plan_arrives(double now, double period) {
  const bool paused = last_cycle_ && (now < *last_cycle_ || is_pause(now - *last_cycle_, period));
  if (paused) latched_ = false;
  return paused;
}

bool GoalChecker::update(const Pose2& robot, const Twist2& velocity, const Pose2& goal, const Parameters& parameters,
                         bool next) {
  const double left = distance(robot, goal);
  const double tolerance = parameters.xy_goal_tolerance;
  latched_ = (next && left <= tolerance) || (latched_ && left <= tolerance + goal_margin(parameters));
  const bool aligned = std::abs(wrap_angle(goal.theta - robot.theta)) <= parameters.yaw_goal_tolerance;
  return latched_ && aligned && at_rest(velocity, parameters);
}

}  // namespace hidwa_local_planner
