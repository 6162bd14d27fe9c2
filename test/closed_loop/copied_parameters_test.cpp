// SPDX-License-Identifier: BSD-3-Clause
// Numbers of other planners' parameter files, as they are: the robot reaches a goal ahead, one behind and one with a
// heading.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/parameter_text.hpp"
#include "support/scene_loop.hpp"

namespace hidwa_local_planner::test {
namespace {

struct File {
  const char* name;
  double frequency;     // of the control cycle [Hz]
  std::string numbers;  // what has a name of ours
};

const std::string kBurger =
    "max_vel_x=0.22 max_vel_theta=2.75 acc_lim_x=2.5 acc_lim_theta=3.2 xy_goal_tolerance=0.05 yaw_goal_tolerance=0.17 "
    "sim_time=1.5 vx_samples=20 vth_samples=40 ";

const File kFiles[] = {
    {"TurtleBot 3 burger", 10.0, kBurger + "min_vel_x=-0.22"},
    {"TurtleBot 3 burger, minima by the hints of old", 10.0, kBurger + "min_vel_x=0.11 min_in_place_vel_theta=1.37"},
    {"TurtleBot 3 waffle_pi", 10.0,
     "max_vel_x=0.26 min_vel_x=-0.26 max_vel_theta=1.82 acc_lim_x=2.5 acc_lim_theta=3.2 xy_goal_tolerance=0.05 "
     "yaw_goal_tolerance=0.17 sim_time=2.0 vx_samples=20 vth_samples=40"},
    {"Jackal", 20.0,
     "max_vel_x=0.5 min_vel_x=0.1 max_vel_theta=1.57 min_in_place_vel_theta=0.314 acc_lim_x=10.0 acc_lim_theta=20.0 "
     "xy_goal_tolerance=0.25 yaw_goal_tolerance=0.157 sim_time=2.0 vx_samples=6"},
    {"Husky", 20.0,
     "max_vel_x=3.0 min_vel_x=0.0 max_vel_theta=1.0 min_in_place_vel_theta=0.2 acc_lim_x=2.5 acc_lim_theta=3.2 "
     "xy_goal_tolerance=0.2 yaw_goal_tolerance=0.1 sim_time=2.0 vx_samples=6"},
    {"TurtleBot 2", 20.0,
     "max_vel_x=0.3 min_vel_x=0.0 max_vel_theta=1.0 acc_lim_x=0.5 acc_lim_theta=1.0 xy_goal_tolerance=0.15 "
     "yaw_goal_tolerance=0.3 sim_time=3.0 vx_samples=6"},
    {"TEB, a slow base", 20.0,
     "max_vel_x=0.25 acc_lim_x=0.2 max_vel_theta=0.5 acc_lim_theta=0.4 xy_goal_tolerance=0.2 yaw_goal_tolerance=0.125"},
    {"DWB", 20.0,
     "max_vel_x=0.26 min_vel_x=0.0 max_vel_theta=1.0 acc_lim_x=2.5 acc_lim_theta=3.2 decel_lim_x=-2.5 "
     "decel_lim_theta=-3.2 xy_goal_tolerance=0.25 sim_time=1.7 vx_samples=20 transform_tolerance=0.2"},
    {"Any, whose least speed is nearly its largest", 20.0, "max_vel_x=0.5 min_vel_x=0.4"}};

Parameters parameters_of(const File& file) {
  Parameters parameters;
  std::string lines = file.numbers;
  std::replace(lines.begin(), lines.end(), ' ', '\n');
  EXPECT_EQ(set_lines(parameters, lines), std::vector<std::string>());
  return parameters;
}

// In free space.
Course drive(const File& file, const Pose2& goal) {
  Scene scene = Scene::empty(161, 0.05);
  scene.parameters = parameters_of(file);
  scene.outline = {{0.15, 0.15}, {-0.15, 0.15}, {-0.15, -0.15}, {0.15, -0.15}};
  Situation& now = scene.situation;
  now.pose = {};
  now.time = 1.0;
  now.period = 1.0 / file.frequency;
  now.goal = goal;
  now.plan.clear();
  for (int k = 0; k <= 40; ++k) now.plan.push_back({goal.x * k / 40.0, goal.y * k / 40.0, 0.0});
  now.plan.back() = goal;
  return drive_to_goal(scene, 60.0);
}

TEST(CopiedParameters, ReachAGoalAheadOneBehindAndOneWithAHeading) {
  for (const File& file : kFiles) {
    for (const Pose2& goal : {Pose2{2.0, 0.0, 0.0}, Pose2{-2.0, 0.0, M_PI}, Pose2{1.0, 1.0, -0.5 * M_PI}}) {
      const Course course = drive(file, goal);
      EXPECT_TRUE(course.arrived) << file.name << ", goal " << goal.x << " " << goal.y << ": " << course.problem;
      EXPECT_EQ(course.problem, "") << file.name << ", goal " << goal.x << " " << goal.y;
    }
  }
}

}  // namespace
}  // namespace hidwa_local_planner::test
