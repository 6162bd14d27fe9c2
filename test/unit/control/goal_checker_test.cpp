// SPDX-License-Identifier: BSD-3-Clause
#include "control/goal_checker.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

// Tolerances 0.25 m and 0.25 rad; stopped below 0.1 m/s and 0.1 rad/s.
Parameters stopped_below(double v, double omega) {
  Parameters p;
  p.trans_stopped_velocity = v;
  p.rot_stopped_velocity = omega;
  return p;
}

const Parameters kDefaults = stopped_below(0.1, 0.1);
const Pose2 kGoal{2.0, 1.0, 3.1};

TEST(GoalChecker, NeedsPositionHeadingAndRest) {
  GoalChecker checker;
  EXPECT_FALSE(checker.update({1.74, 1.0, 3.1}, {}, kGoal, kDefaults));  // 0.26 m away
  EXPECT_FALSE(checker.latched());
  EXPECT_FALSE(checker.update({1.76, 1.0, 2.8}, {}, kGoal, kDefaults));  // 0.24 m, but 0.3 rad
  EXPECT_TRUE(checker.latched());
  EXPECT_FALSE(checker.update({1.76, 1.0, 3.0}, {0.11, 0.0}, kGoal, kDefaults));
  EXPECT_FALSE(checker.update({1.76, 1.0, 3.0}, {0.0, -0.11}, kGoal, kDefaults));
  EXPECT_FALSE(checker.update({1.76, 1.0, 3.0}, {-0.11, 0.0}, kGoal, kDefaults));
  EXPECT_TRUE(checker.update({1.76, 1.0, 3.0}, {0.09, -0.09}, kGoal, kDefaults));
}

TEST(GoalChecker, HeadingsCountAcrossPi) {
  GoalChecker checker;
  // From 3.1 to -3.1 there are 2 pi - 6.2 = 0.083 rad, to -2.9 there are 2 pi - 6.0 = 0.283 rad.
  EXPECT_TRUE(checker.update({2.0, 1.0, -3.1}, {}, kGoal, kDefaults));
  EXPECT_FALSE(checker.update({2.0, 1.0, -2.9}, {}, kGoal, kDefaults));
}

TEST(GoalChecker, AnyHeadingIsRightWithAToleranceOfAFullTurn) {
  Parameters p = kDefaults;
  p.yaw_goal_tolerance = 2.0 * M_PI;
  EXPECT_TRUE(validate(p).empty());
  GoalChecker checker;
  for (const double heading : {3.1, -3.1, 0.0, 3.1 - M_PI})
    EXPECT_TRUE(checker.update({2.0, 1.0, heading}, {}, kGoal, p));
  p.yaw_goal_tolerance = 6.5;
  EXPECT_EQ(validate(p).size(), 1u);
}

TEST(GoalChecker, PositionIsLatchedUntilReset) {
  GoalChecker checker;
  checker.update({2.0, 1.0, 0.0}, {}, kGoal, kDefaults);
  EXPECT_TRUE(checker.update({2.45, 1.0, 3.1}, {}, kGoal, kDefaults));  // drifted 0.45 m while turning
  checker.reset();
  EXPECT_FALSE(checker.latched());
  EXPECT_FALSE(checker.update({2.45, 1.0, 3.1}, {}, kGoal, kDefaults));
}

TEST(GoalChecker, TheLatchEndsBeyondToleranceAndMargin) {
  Parameters p = kDefaults;
  const auto lasts_at = [&p](double away) {
    GoalChecker checker;
    checker.update(kGoal, {}, kGoal, p);
    return checker.update({kGoal.x + away, kGoal.y, kGoal.theta}, {}, kGoal, p);
  };
  EXPECT_TRUE(lasts_at(0.499));  // 0.25 + 0.25 m
  EXPECT_FALSE(lasts_at(0.501));
  p.xy_goal_tolerance = 0.01;  // the margin is 0.05 m at the least
  EXPECT_TRUE(lasts_at(0.059));
  EXPECT_FALSE(lasts_at(0.061));
  p.xy_goal_tolerance = 2.0;  // and 0.25 m at the most
  EXPECT_TRUE(lasts_at(2.249));
  EXPECT_FALSE(lasts_at(2.251));
}

// At 20 Hz a pause is longer than max(4 x 0.05, 0.3) = 0.3 s, at 5 Hz than 4 x 0.2 = 0.8 s.
TEST(GoalChecker, APlanAfterAPauseEndsTheLatch) {
  const auto lasts = [](double silence, double period) {
    GoalChecker checker;
    checker.cycle(100.0);
    checker.update(kGoal, {}, kGoal, kDefaults);
    const bool paused = checker.plan_arrives(100.0 + silence, period);
    EXPECT_NE(paused, checker.latched());
    return checker.latched();
  };
  EXPECT_TRUE(lasts(0.0, 0.05));  // in the moment of the last cycle
  EXPECT_TRUE(lasts(0.29, 0.05));
  EXPECT_FALSE(lasts(0.31, 0.05));
  EXPECT_TRUE(lasts(0.79, 0.2));
  EXPECT_FALSE(lasts(0.81, 0.2));
  EXPECT_FALSE(lasts(-0.01, 0.05));  // the clock was set back
}

TEST(GoalChecker, APlanBeforeTheFirstCycleFollowsNoPause) {
  GoalChecker checker;
  EXPECT_FALSE(checker.plan_arrives(100.0, 0.05));
}

}  // namespace
}  // namespace hidwa_local_planner
