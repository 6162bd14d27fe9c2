// SPDX-License-Identifier: BSD-3-Clause
// The goal's position is reached where the outline cannot turn to the goal's heading: a robot with a long tail.
#include <cmath>

#include <gtest/gtest.h>

#include "support/effort.hpp"
#include "support/naive_collision.hpp"
#include "support/naive_inflation.hpp"
#include "support/random.hpp"
#include "support/scene_loop.hpp"

namespace hidwa_local_planner::test {
namespace {

// It stands at (-0.23, 0), which is within 0.25 m of the goal at (0, 0), and faces along +x. Its corners behind are
// hypot(0.9, 0.2) = 0.92 m from its centre.
Scene at_the_goal(double heading) {
  Scene scene = Scene::empty(141, 0.05);
  scene.parameters = Parameters();
  scene.outline = {{0.2, 0.2}, {-0.9, 0.2}, {-0.9, -0.2}, {0.2, -0.2}};
  scene.situation.pose = {-0.23, 0.0, 0.0};
  scene.situation.time = 1.0;
  scene.situation.plan.clear();
  for (int k = 0; k <= 20; ++k) scene.situation.plan.push_back({-1.0 + 0.05 * k, 0.0, 0.0});
  scene.situation.goal = {0.0, 0.0, heading};
  scene.situation.plan.back() = scene.situation.goal;
  return scene;
}

Course drive(Scene scene, double duration) {
  inflate(scene, 0.2, 0.8, 3.0);
  return drive_to_goal(scene, duration);
}

// Two posts beside its tail are 0.85 m from its centre, less than 0.92 m. 0.3 m farther on they are 1.13 m from it.
TEST(LastTurn, DrivesOnWithinTheToleranceToWhereItCanTurn) {
  Scene scene = at_the_goal(0.5 * M_PI);
  scene.fill(-1.05, -0.4, -0.95, -0.3);
  scene.fill(-1.05, 0.3, -0.95, 0.4);
  const Course course = drive(scene, 20.0);
  EXPECT_TRUE(course.arrived);
  EXPECT_EQ(course.failures, 0);
  EXPECT_FALSE(course.touched);
  EXPECT_LE(course.farthest, 0.25);
}

// Posts beside its tail, but for two places: those that it drives over for 0.3 m straight on, and those that it turns
// over there, both with 0.05 m to spare and more.
TEST(LastTurn, EndsAmongPostsWhereverItCouldDriveOnAndTurn) {
  int blocked = 0;
  for (std::uint64_t seed = 1; seed <= effort(16u, 40u); ++seed) {
    Random random(seed);
    Scene scene = at_the_goal(random.uniform(-M_PI, M_PI));
    for (int k = 0; k < 12; ++k) {
      const double side = random.chance(0.5) ? 1.0 : -1.0;
      const double angle = side * random.uniform(1.8, 2.9), away = random.uniform(1.1, 1.3);
      const double x = 0.07 + away * std::cos(angle), y = away * std::sin(angle);
      if (std::abs(y) < 0.35 && x < 0.0) continue;
      scene.fill(x - 0.05, y - 0.05, x + 0.05, y + 0.05);
    }
    Pose2 there = scene.situation.pose;
    const double turn = wrap_angle(scene.situation.goal.theta);
    bool free = true;
    for (int k = 0; k <= 50; ++k) {
      there.theta = turn * k / 50.0;
      free = free && naive_overlap(scene.grid(), {scene.outline, 0.0}, there, true) <= 0.0;
    }
    blocked += free ? 0 : 1;
    const Course course = drive(scene, 30.0);
    EXPECT_TRUE(course.arrived) << seed;
    EXPECT_FALSE(course.touched) << seed;
  }
  EXPECT_GT(blocked, effort(4, 10));
}

// A corridor of 0.7 m, in which it cannot turn at all. It ends 0.3 m beyond the goal, whose heading is the other way
// round: it has to turn outside, with all of its tail, and to come back.
TEST(LastTurn, GoesOutOfTheToleranceAndBackWhereNothingElseLeadsToTheHeading) {
  Scene scene = at_the_goal(M_PI);
  scene.fill(-3.5, 0.35, 0.3, 0.45);
  scene.fill(-3.5, -0.45, 0.3, -0.35);
  const Course course = drive(scene, 60.0);
  EXPECT_TRUE(course.arrived);
  EXPECT_FALSE(course.touched);
  EXPECT_GT(course.farthest, 0.8);  // its tail, 0.9 m long, is out: 0.3 + 0.9 m, less what it turns meanwhile
}

// Closed at its end: there is no way, and the host is told why.
TEST(LastTurn, SaysSoWhereNothingLeadsToTheHeading) {
  Scene scene = at_the_goal(M_PI);
  scene.fill(-3.5, 0.35, 0.6, 0.45);
  scene.fill(-3.5, -0.45, 0.6, -0.35);
  scene.fill(0.5, -0.45, 0.6, 0.45);
  const Course course = drive(scene, 20.0);
  EXPECT_FALSE(course.arrived);
  EXPECT_GT(course.failures, 10);
  EXPECT_LE(course.farthest, 0.25);
}

// An open floor: it turns as ever, at once.
TEST(LastTurn, TurnsOnTheSpotWhereItCan) {
  const Course course = drive(at_the_goal(0.5 * M_PI), 8.0);
  EXPECT_TRUE(course.arrived);
  EXPECT_EQ(course.failures, 0);
  EXPECT_LE(course.farthest, 0.25);
}

}  // namespace
}  // namespace hidwa_local_planner::test
