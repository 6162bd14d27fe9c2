// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/goal_succession.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

const FramedGoal kDesk{"map", {2.0, 1.0, 0.5}};
const FramedGoal kWall{"map", {7.0, 1.0, 0.5}};  // 5 m from the desk

TEST(GoalSuccession, APlanToTheEarlierGoalIsOver) {
  GoalSuccession goals;
  EXPECT_FALSE(goals.is_over(kDesk));  // no goal was heard of
  goals.take(kDesk);
  EXPECT_FALSE(goals.is_over(kDesk));
  goals.take(kWall);
  EXPECT_TRUE(goals.is_over(kDesk));
  EXPECT_FALSE(goals.is_over(kWall));
}

TEST(GoalSuccession, AGoalThatComesAgainIsThePresentOne) {
  GoalSuccession goals;
  for (const FramedGoal& goal : {kDesk, kWall, kDesk}) goals.take(goal);
  EXPECT_FALSE(goals.is_over(kDesk));
  EXPECT_TRUE(goals.is_over(kWall));
}

TEST(GoalSuccession, AnotherHeadingIsAnotherGoal) {
  GoalSuccession goals;
  goals.take(kDesk);
  goals.take({"map", {2.0, 1.0, 2.0}});
  EXPECT_TRUE(goals.is_over(kDesk));
}

// A planner that ends its plans beside a goal that it cannot reach must not be taken for a late one.
TEST(GoalSuccession, APlanThatEndsElsewhereIsNotJudged) {
  GoalSuccession goals;
  goals.take(kDesk);
  goals.take(kWall);
  EXPECT_FALSE(goals.is_over({"map", {6.5, 1.0, 0.5}}));
  EXPECT_FALSE(goals.is_over({"odom", kDesk.pose}));
  EXPECT_TRUE(goals.is_over({"map", {2.06, 1.06, 0.5}}));   // 0.085 m beside: a cell of 0.05 m
  EXPECT_FALSE(goals.is_over({"map", {2.08, 1.08, 0.5}}));  // 0.113 m
}

TEST(GoalSuccession, TheLastFourEarlierGoalsAreKept) {
  GoalSuccession goals;
  for (double x = 0.0; x < 6.0; x += 1.0) goals.take({"map", {x, 0.0, 0.0}});
  EXPECT_FALSE(goals.is_over({"map", {0.0, 0.0, 0.0}}));
  for (double x = 1.0; x < 5.0; x += 1.0) EXPECT_TRUE(goals.is_over({"map", {x, 0.0, 0.0}})) << x;
}

}  // namespace
}  // namespace hidwa_local_planner
