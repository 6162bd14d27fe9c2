// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/tie_rule.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

// Accelerations 2.5 m/s^2 and 3.2 rad/s^2.
TieRule least_change(const Twist2& last) { return TieRule(Parameters(), last); }

TEST(LeastChange, TheSmallestChangeInTimeWins) {
  const TieRule rule = least_change({0.3, 0.0});
  // 0.1 / 2.5 = 0.04 s against 0.16 / 3.2 = 0.05 s.
  EXPECT_TRUE(rule.prefers({0.2, 0.0}, {0.3, 0.16}));
  EXPECT_FALSE(rule.prefers({0.3, 0.16}, {0.2, 0.0}));
}

TEST(LeastChange, ThenTheSmallerTurn) {
  const TieRule rule = least_change({0.25, 0.32});
  // Both 0.1 s away: (0.25, 0.0) by 0.32 / 3.2, (0.5, 0.32) by 0.25 / 2.5.
  EXPECT_TRUE(rule.prefers({0.25, 0.0}, {0.5, 0.32}));
  EXPECT_FALSE(rule.prefers({0.5, 0.32}, {0.25, 0.0}));
}

TEST(LeastChange, ThenTheSideOfTheLastTurn) {
  // Equal change: |0.2 - w| and |-0.2 - w| differ unless w = 0, so the side of a turn is decided by change
  // already.
  const TieRule right = least_change({0.0, -0.1});
  EXPECT_TRUE(right.prefers({0.0, -0.2}, {0.0, 0.2}));
  EXPECT_FALSE(right.prefers({0.0, 0.2}, {0.0, -0.2}));
  // Within rounding of a tie only the last turn's sign is left.
  const TieRule barely = least_change({0.0, -1e-10});
  EXPECT_TRUE(barely.prefers({0.0, -0.2}, {0.0, 0.2}));
}

TEST(LeastChange, ThenLeft) {
  const TieRule rule = least_change({0.3, 0.0});
  EXPECT_TRUE(rule.prefers({0.3, 0.2}, {0.3, -0.2}));
  EXPECT_FALSE(rule.prefers({0.3, -0.2}, {0.3, 0.2}));
  EXPECT_FALSE(rule.prefers({0.3, 0.2}, {0.3, 0.2}));  // nothing is preferred to itself
}

TEST(First, LowestSpeedThenMostNegativeTurn) {
  Parameters p;
  p.method = Method::paper;
  const TieRule rule(p, {0.5, 1.0});
  EXPECT_TRUE(rule.prefers({0.1, 1.0}, {0.2, -1.0}));
  EXPECT_TRUE(rule.prefers({0.1, -0.5}, {0.1, 0.5}));
  EXPECT_FALSE(rule.prefers({0.1, 0.5}, {0.1, -0.5}));
  EXPECT_FALSE(rule.prefers({0.1, 0.5}, {0.1, 0.5}));
}

}  // namespace
}  // namespace hidwa_local_planner
