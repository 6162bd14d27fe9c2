// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/goal_checker.hpp"

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
  // -3.1 is 2 pi - 6.2 = 0.083 rad from 3.1.
  EXPECT_TRUE(checker.update({2.0, 1.0, -3.1}, {}, kGoal, kDefaults));
}

TEST(GoalChecker, AnyHeadingIsRightWithAToleranceOfAFullTurn) {
  Parameters p = kDefaults;
  p.yaw_goal_tolerance = 2.0 * M_PI;
  EXPECT_TRUE(validate(p).empty());
  GoalChecker checker;
  for (const double heading : {3.1, -3.1, 0.0, 3.1 - M_PI}) EXPECT_TRUE(checker.update({2.0, 1.0, heading}, {}, kGoal, p));
  p.yaw_goal_tolerance = 6.5;
  EXPECT_EQ(validate(p).size(), 1u);
}

TEST(GoalChecker, PositionIsLatchedUntilReset) {
  GoalChecker checker;
  checker.update({2.0, 1.0, 0.0}, {}, kGoal, kDefaults);
  EXPECT_TRUE(checker.update({2.6, 1.0, 3.1}, {}, kGoal, kDefaults));  // drifted 0.6 m while turning
  checker.reset();
  EXPECT_FALSE(checker.latched());
  EXPECT_FALSE(checker.update({2.6, 1.0, 3.1}, {}, kGoal, kDefaults));
}

}  // namespace
}  // namespace hidwa_local_planner
