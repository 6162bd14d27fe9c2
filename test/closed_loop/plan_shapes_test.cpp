// SPDX-License-Identifier: BSD-3-Clause
// Plans of any spacing and shape: poses far apart, hairpins, loops, crossings, spirals, zigzags, plans that end where
// they begin or pass their goal on the way, plans without headings, and goals that jitter.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "plan_drive.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner::test {
namespace {

constexpr double kTolerance = 0.25;  // xy_goal_tolerance [m]

PlanShape straight_through(const std::vector<std::pair<double, double>>& corners, double spacing = 0.05) {
  PlanShape plan{{corners.front().first, corners.front().second, 0.0}};
  for (std::size_t k = 1; k < corners.size(); ++k) go_to(plan, corners[k].first, corners[k].second, spacing);
  return plan;
}

// Out along +x, half a circle to the left, and back.
PlanShape hairpin(double apart) {
  PlanShape plan = straight_through({{0.0, 0.0}, {5.0, 0.0}});
  go_round(plan, 0.5 * apart, M_PI);
  go_to(plan, 0.0, apart);
  return plan;
}

// A leg every `leg` [m], with the angle `inner` between two legs.
PlanShape zigzag(double leg, double inner) {
  std::vector<std::pair<double, double>> corners = {{0.0, 0.0}};
  for (int k = 0; k < 5; ++k) {
    const double angle = (k % 2 == 0 ? 0.5 : -0.5) * (M_PI - inner);
    corners.emplace_back(corners.back().first + leg * std::cos(angle), corners.back().second + leg * std::sin(angle));
  }
  return straight_through(corners);
}

// Inwards to its centre, or outwards.
PlanShape spiral(double apart, bool inwards) {
  PlanShape plan;
  for (double angle = 0.0; angle <= 5.0 * M_PI; angle += 0.05) {
    const double radius = 0.3 + apart * angle / (2.0 * M_PI);
    plan.push_back({radius * std::cos(angle), radius * std::sin(angle), angle + 0.5 * M_PI});
  }
  if (!inwards) return plan;
  std::reverse(plan.begin(), plan.end());
  for (Pose2& pose : plan) pose.theta += M_PI;
  return plan;
}

PlanCourse drive(const PlanShape& plan, double longest = 120.0, const Parameters& parameters = {}) {
  PlanDrive robot(parameters);
  robot.put({plan.front().x, plan.front().y, plan.front().theta});
  robot.plan(plan);
  return robot.run(longest);
}

TEST(PlanShapes, AnySpacingDrivesAsADensePlan) {
  for (const std::vector<std::pair<double, double>>& corners :
       {std::vector<std::pair<double, double>>{{0.0, 0.0}, {10.0, 0.0}}, {{0.0, 0.0}, {5.0, 0.0}, {5.0, 5.0}}}) {
    const PlanCourse dense = drive(straight_through(corners));
    ASSERT_TRUE(dense.arrived);
    for (const double spacing : {0.2, 1.0, 4.0, 10.0}) {
      const PlanCourse course = drive(straight_through(corners, spacing));
      EXPECT_TRUE(course.arrived) << spacing;
      EXPECT_NEAR(course.duration, dense.duration, 0.02 * dense.duration) << spacing;
    }
  }
}

// The tip of a hairpin is 5 m out, and half of the lanes' distance.
TEST(PlanShapes, TheTipOfAHairpinIsReached) {
  for (const double apart : {0.1, 0.2, 0.3, 0.45, 0.6, 0.8, 1.0, 1.3}) {
    const PlanShape plan = hairpin(apart);
    const PlanCourse course = drive(plan);
    EXPECT_TRUE(course.arrived) << apart;
    EXPECT_EQ(course.failures, 0) << apart;
    EXPECT_LE(course.nearest_to({5.0 + 0.5 * apart, 0.5 * apart, 0.0}), kTolerance) << apart;
    EXPECT_LE(farthest_apart(plan, course.track), 0.45) << apart;
  }
}

// Four lanes of 3 m.
PlanShape lanes(double apart) {
  return straight_through({{0.0, 0.0},
                           {3.0, 0.0},
                           {3.0, apart},
                           {0.0, apart},
                           {0.0, 2.0 * apart},
                           {3.0, 2.0 * apart},
                           {3.0, 3.0 * apart},
                           {0.0, 3.0 * apart}});
}

// On the way straight on, once round.
PlanShape loop(double radius) {
  PlanShape plan = straight_through({{0.0, 0.0}, {2.0, 0.0}});
  go_round(plan, radius, 2.0 * M_PI);
  go_to(plan, 5.0, 0.0);
  return plan;
}

PlanShape circle(double radius) {
  PlanShape plan{{0.0, 0.0, 0.0}};
  go_round(plan, radius, 2.0 * M_PI);
  return plan;
}

PlanShape eight(double radius) {
  PlanShape plan = circle(radius);
  go_round(plan, radius, -2.0 * M_PI);
  return plan;
}

// It arrives, and is never farther than `off` from where the plan leads in its order.
TEST(PlanShapes, EachIsDrivenInItsOrder) {
  struct Row {
    std::string name;
    PlanShape plan;
    double off;  // [m]
  };
  std::vector<Row> rows = {
      {"a spike, out and back by the same way", straight_through({{0.0, 0.0}, {4.0, 0.0}, {1.0, 0.0}}), 0.45},
      {"a spike to where it begins", straight_through({{0.0, 0.0}, {3.0, 0.0}, {0.0, 0.0}}), 0.45},
      {"a square", straight_through({{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}, {0.0, 0.0}}), 0.6},
      {"a spiral outwards", spiral(0.5, false), 0.5},
      {"a spiral inwards", spiral(0.5, true), 0.5}};
  const auto add = [&rows](const std::string& name, double size, PlanShape plan, double off) {
    rows.push_back({name + " of " + std::to_string(size) + " m", std::move(plan), off});
  };
  for (const double apart : {0.3, 0.5}) add("lanes", apart, lanes(apart), 0.45);
  for (const double inner : {0.3, 0.6, 0.9}) {
    const std::string name = "a zigzag with " + std::to_string(inner) + " rad in its corners";
    for (const double leg : {1.0, 2.0}) add(name, leg, zigzag(leg, inner), 0.55);
  }
  for (const double radius : {0.3, 0.5, 1.0}) {
    add("a loop", radius, loop(radius), 0.5);
    add("an eight", radius, eight(radius), 0.5);
  }
  for (const double radius : {0.5, 1.0, 2.0}) add("a circle", radius, circle(radius), 0.4);
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    const PlanCourse course = drive(row.plan);
    EXPECT_TRUE(course.arrived);
    EXPECT_EQ(course.failures, 0);
    EXPECT_LE(farthest_apart(row.plan, course.track), row.off);
  }
}

// The goal lies on the way out to the tip.
TEST(PlanShapes, AGoalThatIsPassedOnTheWayToATipDoesNotCountYet) {
  for (const double goal : {1.0, 2.0}) {
    const PlanCourse course = drive(straight_through({{0.0, 0.0}, {4.0, 0.0}, {goal, 0.0}}));
    EXPECT_TRUE(course.arrived) << goal;
    EXPECT_LE(course.nearest_to({4.0, 0.0, 0.0}), kTolerance) << goal;
  }
}

TEST(PlanShapes, APlanToWhereTheRobotStandsIsReachedAtOnce) {
  EXPECT_EQ(drive({{0.0, 0.0, 0.0}}).duration, 0.0);
  const PlanCourse course = drive(straight_through({{0.0, 0.0}, {0.1, 0.0}, {0.0, 0.1}, {-0.1, 0.0}, {0.0, 0.0}}));
  EXPECT_TRUE(course.arrived);
  EXPECT_LE(course.nearest_to({0.0, 0.0, 0.0}), 0.0);
  EXPECT_LE(course.duration, 3.0);  // the last turn, to the heading of the way from (-0.1, 0)
}

// A block is at the tip: no centre comes nearer to it than 0.2 m. The robot goes on without it.
TEST(PlanShapes, ATipInAnObstacleDoesNotStopTheRobot) {
  const PlanShape plan = hairpin(0.6);
  PlanDrive robot;
  robot.obstacle = [](double x, double y) { return x > 4.9 && x < 5.6 && y > 0.1 && y < 0.5; };
  robot.plan(plan);
  const PlanCourse course = robot.run(120.0);
  EXPECT_TRUE(course.arrived);
}

// The host sends the same plan again each second.
TEST(PlanShapes, APlanThatIsSentAgainDoesNotBeginAgain) {
  for (const PlanShape& plan : {hairpin(0.2), straight_through({{0.0, 0.0}, {3.0, 0.0}, {0.0, 0.0}})}) {
    PlanDrive robot;
    robot.host = [&plan, next = 0.0](PlanDrive& drive) mutable {
      if (drive.time() < next) return;
      drive.plan(plan);
      next += 1.0;
    };
    const PlanCourse course = robot.run(120.0);
    EXPECT_TRUE(course.arrived);
    EXPECT_LE(farthest_apart(plan, course.track), 0.45);
  }
}

// From 2.5 m on the person turns the robot round to the left, until it looks back: then it is on the other lane, 0.6 m
// to the left. v / omega = 0.3 m is half of that.
TEST(PlanShapes, WhatIsPassedBySteeringCountsAsDriven) {
  const PlanShape plan = hairpin(0.6);
  PlanDrive robot;
  robot.plan(plan);
  bool turned = false;
  robot.wants = [&turned](const PlanDrive& drive) {
    OperatorIntent intent;
    if (drive.pose().x < 2.5 || turned) return intent;
    turned = std::abs(drive.pose().theta) > 2.9;
    intent.state = OperatorStateId::shared;
    intent.influence = Influence::shared;
    intent.u_h = {0.3, 1.0};
    return intent;
  };
  const PlanCourse course = robot.run(120.0);
  EXPECT_TRUE(turned);
  EXPECT_TRUE(course.arrived);
  EXPECT_GT(course.nearest_to({5.3, 0.3, 0.0}), 1.5);  // it does not go back to the tip
}

// Planners without headings leave the robot as it arrives: along +y.
TEST(PlanShapes, WithoutAHeadingAnyOneWillDoAtTheGoal) {
  PlanShape plan = straight_through({{0.0, 0.0}, {0.0, 4.0}});
  for (Pose2& pose : plan) pose.theta = std::numeric_limits<double>::quiet_NaN();
  PlanDrive robot;
  robot.put({0.0, 0.0, 0.5 * M_PI});
  robot.plan(plan);
  const PlanCourse course = robot.run(60.0);
  EXPECT_TRUE(course.arrived);
  EXPECT_NEAR(course.track.back().theta, 0.5 * M_PI, 0.15);
  EXPECT_LE(course.duration, 4.0 / 0.5 + 2.0);  // at full speed, and slowing down
}

// The plan ends up to 0.08 m beside the goal, each time elsewhere, and each time turned by up to 0.1 rad.
TEST(PlanShapes, AGoalThatJittersIsOneGoal) {
  Random random(7);
  PlanDrive robot;
  Pose2 end;
  robot.host = [&, next = 0.0](PlanDrive& drive) mutable {
    if (drive.time() < next) return;
    next += 0.5;
    const Pose2 from = drive.pose();
    PlanShape plan{from};
    const double x = 6.0 + random.uniform(-0.08, 0.08), y = 3.0 + random.uniform(-0.08, 0.08);
    go_to(plan, x, y);
    plan.back().theta = 2.0 + random.uniform(-0.1, 0.1);
    end = plan.back();
    drive.plan(plan);
  };
  const PlanCourse course = robot.run(60.0);
  EXPECT_TRUE(course.arrived);
  EXPECT_EQ(course.new_goals, 1);
  EXPECT_LE(distance(course.track.back(), end), 2.0 * kTolerance);
}

// What a planner creeps on with is a new goal in the end: 0.05 m with each plan, after each 0.25 m.
TEST(PlanShapes, AGoalThatMovesOnIsANewGoalAfterItsTolerance) {
  PlanDrive robot;
  robot.host = [plans = 0](PlanDrive& drive) mutable {
    if (drive.time() < 0.2 * plans || plans > 20) return;
    PlanShape plan{drive.pose()};
    go_to(plan, 4.0 + 0.05 * plans, 0.0);
    ++plans;
    drive.plan(plan);
  };
  const PlanCourse course = robot.run(60.0);
  EXPECT_TRUE(course.arrived);
  EXPECT_EQ(course.new_goals, 1 + 3);  // at 0.30, 0.60 and 0.90 m of 1 m
  EXPECT_LE(distance(course.track.back(), {5.0, 0.0, 0.0}), kTolerance);
}

}  // namespace
}  // namespace hidwa_local_planner::test
