// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/goal_succession.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

const FramedGoal kDesk{"map", {2.0, 1.0, 0.5}};
const FramedGoal kWall{"map", {7.0, 1.0, 0.5}};  // 5 m from the desk

TEST(GoalSuccession, APlanToTheEarlierGoalIsOver) {
  GoalSuccession goals;
  EXPECT_FALSE(goals.leads_to_earlier_goal(kDesk));  // no goal was heard of
  goals.take(kDesk, 1.0);
  EXPECT_FALSE(goals.leads_to_earlier_goal(kDesk));
  goals.take(kWall, 1.0);
  EXPECT_TRUE(goals.leads_to_earlier_goal(kDesk));
  EXPECT_FALSE(goals.leads_to_earlier_goal(kWall));
}

TEST(GoalSuccession, AGoalThatComesAgainIsThePresentOne) {
  GoalSuccession goals;
  for (const FramedGoal& goal : {kDesk, kWall, kDesk}) goals.take(goal, 1.0);
  EXPECT_FALSE(goals.leads_to_earlier_goal(kDesk));
  EXPECT_TRUE(goals.leads_to_earlier_goal(kWall));
}

TEST(GoalSuccession, AnotherHeadingIsAnotherGoal) {
  GoalSuccession goals;
  goals.take(kDesk, 1.0);
  goals.take({"map", {2.0, 1.0, 2.0}}, 1.0);
  EXPECT_TRUE(goals.leads_to_earlier_goal(kDesk));
}

// A planner that ends its plans beside a goal that it cannot reach must not be taken for a late one.
TEST(GoalSuccession, APlanThatEndsElsewhereIsNotJudged) {
  GoalSuccession goals;
  goals.take(kDesk, 1.0);
  goals.take(kWall, 1.0);
  EXPECT_FALSE(goals.leads_to_earlier_goal({"map", {6.5, 1.0, 0.5}}));
  EXPECT_FALSE(goals.leads_to_earlier_goal({"odom", kDesk.pose}));
  EXPECT_TRUE(goals.leads_to_earlier_goal({"map", {2.06, 1.06, 0.5}}));   // 0.085 m beside: a cell of 0.05 m
  EXPECT_FALSE(goals.leads_to_earlier_goal({"map", {2.08, 1.08, 0.5}}));  // 0.113 m
}

TEST(GoalSuccession, TheLastFourEarlierGoalsAreKept) {
  GoalSuccession goals;
  for (double x = 0.0; x < 6.0; x += 1.0) goals.take({"map", {x, 0.0, 0.0}}, 1.0);
  EXPECT_FALSE(goals.leads_to_earlier_goal({"map", {0.0, 0.0, 0.0}}));
  for (double x = 1.0; x < 5.0; x += 1.0) EXPECT_TRUE(goals.leads_to_earlier_goal({"map", {x, 0.0, 0.0}})) << x;
}

// A robot that follows somebody: a goal every 0.2 s, 0.15 m on, and plans that take 0.3 s: each comes when its goal is
// one or two goals old, 0.15 or 0.3 m away.
TEST(GoalSuccession, APlanToTheGoalOfJustNowLeadsOnWhereThePresentOneIsNear) {
  GoalSuccession goals;
  for (int k = 0; k < 20; ++k) {
    const auto goal = [](int n) { return FramedGoal{"map", {0.15 * n, 0.0, 0.0}}; };
    const double now = 10.0 + 0.2 * k;
    goals.take(goal(k), now);
    if (k < 2) continue;
    for (const int late : {1, 2}) {
      EXPECT_TRUE(goals.leads_to_earlier_goal(goal(k - late)));
      EXPECT_TRUE(goals.leads_on(goal(k - late), now + 0.1));
    }
  }
}

TEST(GoalSuccession, APlanToAGoalFarAwayOrLongAgoLeadsNowhere) {
  GoalSuccession goals;
  goals.take(kDesk, 1.0);
  EXPECT_FALSE(goals.leads_on(kDesk, 1.0));  // it is the present one
  goals.take(kWall, 10.0);
  EXPECT_FALSE(goals.leads_on(kDesk, 10.1));
  const FramedGoal beside{"map", {7.9, 1.0, 0.5}}, beyond{"map", {8.1, 1.0, 0.5}};  // 0.9 and 1.1 m from the wall's
  goals.take(beside, 20.0);
  EXPECT_TRUE(goals.leads_on(kWall, 21.9));
  EXPECT_FALSE(goals.leads_on(kWall, 22.1));  // no plan to the present goal has come for 2.1 s
  goals.take(kWall, 30.0);
  goals.take(beyond, 31.0);
  EXPECT_FALSE(goals.leads_on(kWall, 31.1));
}

// Plans without orientations: a heading that is not a number is any heading.
TEST(GoalSuccession, APlanWithoutHeadingLeadsToThePresentGoal) {
  GoalSuccession goals;
  goals.take({"map", {2.0, 1.0, 0.0}}, 1.0);
  goals.take({"map", {2.0, 1.0, 2.0}}, 2.0);
  EXPECT_FALSE(goals.leads_to_earlier_goal({"map", {2.0, 1.0, std::nan("")}}));
}

}  // namespace
}  // namespace hidwa_local_planner
