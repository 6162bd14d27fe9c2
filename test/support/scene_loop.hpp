// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "control/control_loop.hpp"
#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/naive_collision.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

/// The control loop of a robot in a scene. Pose, velocity, time, periods and the operator's intent are the scene's at
/// each cycle; its plan and, behind that, its goal are what the host plans. The last command is the loop's own.
class SceneLoop {
 public:
  /// `scene` must outlive it. Without a plan in the scene, nothing is planned yet.
  explicit SceneLoop(const Scene& scene) : scene_(scene), loop_(critics::built_in()) {
    EXPECT_EQ(loop_.configure(scene.parameters), std::vector<std::string>{});
    loop_.set_footprint(scene.outline);
    if (!scene.situation.plan.empty()) plan();
  }

  /// The host plans anew.
  void plan() {
    std::vector<Pose2> plan = scene_.situation.plan;
    const Pose2& goal = scene_.situation.goal;
    if (distance(plan.back(), goal) > 1e-6) plan.push_back(goal);
    loop_.set_plan(std::move(plan), "map", scene_.situation.time, scene_.situation.period);
  }

  bool doubts_velocity() const { return loop_.doubts_velocity(); }
  bool goal_begins() const { return loop_.goal_begins(); }
  bool goal_reached() { return loop_.goal_reached(observe(), false); }

  /// One control cycle, in which nothing is missing; `host_stops`: the host stops the robot.
  control::Result cycle(bool host_stops = false) {
    control::Observation seen = observe();
    seen.host_stops = host_stops;
    return loop_.step(seen, scene_.intent);
  }

 private:
  control::Observation observe() const {
    const Situation& now = scene_.situation;
    control::Observation seen;
    seen.timing = {now.time, now.period, now.longest_period, now.period, false};
    seen.pose = now.pose;
    seen.velocity = now.velocity;
    seen.pose_age = now.pose_age;
    seen.costmap = scene_.grid();
    return seen;
  }

  const Scene& scene_;
  control::ControlLoop loop_;
};

/// The map goes with the robot, which is in its middle.
inline void follow_robot(Scene& scene) {
  const Pose2& pose = scene.situation.pose;
  const double cell = scene.resolution;
  scene.origin_x = std::floor(pose.x / cell) * cell - 0.5 * scene.size_x * cell;
  scene.origin_y = std::floor(pose.y / cell) * cell - 0.5 * scene.size_y * cell;
}

/// For one control period the robot does just what it is told.
inline void carry_out(Scene& scene, const Twist2& u) {
  Situation& now = scene.situation;
  Pose2& pose = now.pose;
  const double middle = pose.theta + 0.5 * u.omega * now.period;
  pose.x += u.v * std::cos(middle) * now.period;
  pose.y += u.v * std::sin(middle) * now.period;
  pose.theta = wrap_angle(pose.theta + u.omega * now.period);
  now.velocity = now.last_command = u;
  now.time += now.period;
}

/// What a drive to the scene's goal came to.
struct Course {
  bool arrived = false;   // it rests at the goal, with its heading
  bool touched = false;   // an obstacle, or the map's edge
  double time = 0.0;      // [s]
  double farthest = 0.0;  // from the goal [m]
  int failures = 0;       // cycles
  // Of the last cycle with a problem: that, and all that rejected a command.
  std::string problem, rejected_by;

  void add(const control::Result& result) {
    failures += result.outcome == Outcome::fail;
    if (result.decision == nullptr || result.decision->problem.empty()) return;
    problem = result.decision->problem;
    rejected_by.clear();
    for (const RejectionCount& rejection : result.decision->rejections) rejected_by += rejection.name;
  }
};

/// A robot that does just what it is told drives until it rests at the goal, `longest` [s] at most. Before each cycle
/// `change` is called with the time since the start [s].
inline Course drive_to_goal(Scene& scene, double longest, const std::function<void(double)>& change = {}) {
  SceneLoop loop(scene);
  const Situation& now = scene.situation;
  const Parameters& p = scene.parameters;
  Course course;
  for (; !course.arrived && course.time < longest; course.time += now.period) {
    if (change) change(course.time);
    const control::Result result = loop.cycle();
    course.add(result);
    carry_out(scene, result.command);
    const double off = distance(now.pose, now.goal);
    course.farthest = std::max(course.farthest, off);
    course.touched = course.touched || naive_overlap(scene.grid(), {scene.outline, 0.0}, now.pose, true) > 0.0;
    course.arrived = result.command == Twist2{} && off <= p.xy_goal_tolerance &&
                     std::abs(wrap_angle(now.goal.theta - now.pose.theta)) <= p.yaw_goal_tolerance;
  }
  return course;
}

}  // namespace hidwa_local_planner::test
