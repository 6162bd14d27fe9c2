// SPDX-License-Identifier: BSD-3-Clause
// Numbers of other planners' parameter files, as they are: the robot reaches a goal ahead, one behind and one with a
// heading.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/scene_loop.hpp"

namespace hidwa_local_planner::test {
namespace {

using Numbers = std::vector<std::pair<std::string, double>>;

struct File {
  const char* name;
  Numbers numbers;  // what has a name of ours
  double frequency = 20.0;
};

// The burger's file with these minima.
Numbers burger(Numbers numbers) {
  const Numbers others = {{"max_vel_x", 0.22},    {"max_vel_theta", 2.75},     {"acc_lim_x", 2.5},
                          {"acc_lim_theta", 3.2}, {"xy_goal_tolerance", 0.05}, {"yaw_goal_tolerance", 0.17},
                          {"sim_time", 1.5},      {"vx_samples", 20},          {"vth_samples", 40}};
  numbers.insert(numbers.end(), others.begin(), others.end());
  return numbers;
}

// `min_vel_theta` is what a user gets who takes a rotational minimum over by its name.
const std::vector<File>& files() {
  static const std::vector<File> all = {
      {"TurtleBot 3 burger", burger({{"min_vel_x", -0.22}}), 10.0},
      {"TurtleBot 3 burger, minima by the hints of old", burger({{"min_vel_x", 0.11}, {"min_vel_theta", 1.37}}), 10.0},
      {"TurtleBot 3 waffle_pi",
       {{"max_vel_x", 0.26},
        {"min_vel_x", -0.26},
        {"max_vel_theta", 1.82},
        {"acc_lim_x", 2.5},
        {"acc_lim_theta", 3.2},
        {"xy_goal_tolerance", 0.05},
        {"yaw_goal_tolerance", 0.17},
        {"sim_time", 2.0},
        {"vx_samples", 20},
        {"vth_samples", 40}},
       10.0},
      {"Jackal",
       {{"max_vel_x", 0.5},
        {"min_vel_x", 0.1},
        {"max_vel_theta", 1.57},
        {"min_in_place_vel_theta", 0.314},
        {"acc_lim_x", 10.0},
        {"acc_lim_theta", 20.0},
        {"xy_goal_tolerance", 0.25},
        {"yaw_goal_tolerance", 0.157},
        {"sim_time", 2.0},
        {"vx_samples", 6}}},
      {"Husky",
       {{"max_vel_x", 3.0},
        {"min_vel_x", 0.0},
        {"max_vel_theta", 1.0},
        {"min_in_place_vel_theta", 0.2},
        {"acc_lim_x", 2.5},
        {"acc_lim_theta", 3.2},
        {"xy_goal_tolerance", 0.2},
        {"yaw_goal_tolerance", 0.1},
        {"sim_time", 2.0},
        {"vx_samples", 6}}},
      {"TurtleBot 2",
       {{"max_vel_x", 0.3},
        {"min_vel_x", 0.0},
        {"max_vel_theta", 1.0},
        {"acc_lim_x", 0.5},
        {"acc_lim_theta", 1.0},
        {"xy_goal_tolerance", 0.15},
        {"yaw_goal_tolerance", 0.3},
        {"sim_time", 3.0},
        {"vx_samples", 6}}},
      {"TEB, a slow base",
       {{"max_vel_x", 0.25},
        {"acc_lim_x", 0.2},
        {"max_vel_theta", 0.5},
        {"acc_lim_theta", 0.4},
        {"xy_goal_tolerance", 0.2},
        {"yaw_goal_tolerance", 0.125}}},
      {"DWB",
       {{"max_vel_x", 0.26},
        {"min_vel_x", 0.0},
        {"max_vel_theta", 1.0},
        {"acc_lim_x", 2.5},
        {"acc_lim_theta", 3.2},
        {"decel_lim_x", -2.5},
        {"decel_lim_theta", -3.2},
        {"xy_goal_tolerance", 0.25},
        {"sim_time", 1.7},
        {"vx_samples", 20},
        {"transform_tolerance", 0.2}}},
      {"Any, whose least speed is nearly its largest", {{"max_vel_x", 0.5}, {"min_vel_x", 0.4}}}};
  return all;
}

// In free space.
Course drive(const File& file, const Pose2& goal) {
  Scene scene = Scene::empty(161, 0.05);
  scene.parameters = Parameters();
  for (const auto& [name, value] : file.numbers) {
    const bool whole = parameter_info(name).type == "int";
    const ParameterValue number = whole ? ParameterValue(static_cast<int>(value)) : ParameterValue(value);
    EXPECT_EQ(set_parameter(scene.parameters, name, number), "") << name;
  }
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
  for (const File& file : files()) {
    for (const Pose2& goal : {Pose2{2.0, 0.0, 0.0}, Pose2{-2.0, 0.0, M_PI}, Pose2{1.0, 1.0, -0.5 * M_PI}}) {
      const Course course = drive(file, goal);
      EXPECT_TRUE(course.arrived) << file.name << ", goal " << goal.x << " " << goal.y << ": " << course.problem;
      EXPECT_EQ(course.problem, "") << file.name << ", goal " << goal.x << " " << goal.y;
    }
  }
}

}  // namespace
}  // namespace hidwa_local_planner::test
