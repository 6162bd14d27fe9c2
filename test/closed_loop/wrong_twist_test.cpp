// SPDX-License-Identifier: BSD-3-Clause
// Odometry whose pose is right and whose velocity is not: always 0, in the odom frame, of the wrong sign or unit. A
// base that ramps drives 8 m with a bend.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "drive_on.hpp"
#include "support/scene_loop.hpp"

namespace hidwa_local_planner::test {
namespace {

/// What the odometry says of the true velocity, at a heading [rad].
using Lie = Twist2 (*)(const Twist2& truth, double heading);

Twist2 truth(const Twist2& u, double) { return u; }
Twist2 zero(const Twist2&, double) { return {}; }
Twist2 in_odom(const Twist2& u, double heading) { return {u.v * std::cos(heading), u.omega}; }
Twist2 mirrored(const Twist2& u, double) { return {-u.v, -u.omega}; }
Twist2 in_millimetres(const Twist2& u, double) { return {1000.0 * u.v, u.omega}; }
Twist2 no_turn(const Twist2& u, double) { return {u.v, 0.0}; }

struct Course {
  bool arrived = false;
  bool doubted = false;
  double time = 0.0;     // [s]
  double changes = 0.0;  // of the commanded speed, from 3 s on [m/s]
};

// `heading`: of the first half of the way; the second turns left by half a right angle.
Course drive(Lie lie, double heading) {
  Scene scene = Scene::empty(401, 0.05);
  scene.parameters = Parameters();
  Situation& now = scene.situation;
  now.time = 1.0;
  now.plan.clear();
  Pose2 on_plan{0.0, 0.0, heading};
  now.pose = on_plan;
  for (int k = 0; k <= 160; ++k) {
    now.plan.push_back(on_plan);
    if (k == 80) on_plan.theta += 0.25 * M_PI;
    on_plan = {on_plan.x + 0.05 * std::cos(on_plan.theta), on_plan.y + 0.05 * std::sin(on_plan.theta), on_plan.theta};
  }
  now.goal = now.plan.back();
  SceneLoop loop(scene);
  sim::DriveLimits limits;
  limits.latency = 0.05;
  sim::DiffDrive base(limits);
  Course course;
  double before = 0.0;
  while (!course.arrived && course.time < 60.0) {
    const control::Result result = loop.cycle();
    if (course.time > 3.0) course.changes += std::abs(result.command.v - before);
    before = result.command.v;
    course.doubted = course.doubted || loop.doubts_velocity();
    course.arrived = result.command == Twist2{} && distance(now.pose, now.goal) < 0.25;
    drive_on(now, base, result.command, 5, [](int) {});
    now.velocity = lie({base.velocity().v, base.velocity().omega}, now.pose.theta);
    course.time += now.period;
  }
  return course;
}

// What is true drives as ever, and nothing is doubted. A velocity that is not true costs the first seconds, in which it
// is found out: at most 10 % of the time, and commands as steady as those of the truth afterwards.
TEST(WrongTwist, IsFoundOutByThePose) {
  struct Case {
    const char* name;
    Lie lie;
    double heading;  // [rad]
  };
  for (const Case& one : {Case{"zero", zero, 0.3}, Case{"in the odom frame", in_odom, 0.5 * M_PI},
                          Case{"in the odom frame, backwards", in_odom, M_PI}, Case{"mirrored", mirrored, 0.0},
                          Case{"in mm/s", in_millimetres, 0.0}}) {
    const Course honest = drive(truth, one.heading), course = drive(one.lie, one.heading);
    EXPECT_TRUE(honest.arrived) << one.name;
    EXPECT_FALSE(honest.doubted) << one.name;
    EXPECT_TRUE(course.arrived) << one.name;
    EXPECT_TRUE(course.doubted) << one.name;
    EXPECT_LT(course.time, 1.1 * honest.time) << one.name;
    EXPECT_LT(course.changes, honest.changes + 1.0) << one.name;
  }
}

// A heading at which the odom frame's velocity is hardly wrong, and a turn that is not measured: they arrive.
TEST(WrongTwist, WhatIsHardlyWrongArrives) {
  const Course honest = drive(truth, 0.1);
  for (const Course& course : {drive(in_odom, 0.1), drive(no_turn, 0.1)}) {
    EXPECT_TRUE(course.arrived);
    EXPECT_LT(course.time, 1.1 * honest.time);
  }
}

}  // namespace
}  // namespace hidwa_local_planner::test
