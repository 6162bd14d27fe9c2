// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/goal_checker.hpp"

#include <cmath>

namespace hidwa_local_planner {

bool GoalChecker::update(const Pose2& robot, const Twist2& velocity, const Pose2& goal,
                         const Parameters& parameters) {
  if (distance(robot, goal) <= parameters.xy_goal_tolerance) latched_ = true;
  const bool aligned = std::abs(wrap_angle(goal.theta - robot.theta)) <= parameters.yaw_goal_tolerance;
  const bool stopped = std::abs(velocity.v) <= parameters.trans_stopped_velocity &&
                       std::abs(velocity.omega) <= parameters.rot_stopped_velocity;
  return latched_ && aligned && stopped;
}

}  // namespace hidwa_local_planner
