// SPDX-License-Identifier: BSD-3-Clause
// When the robot goes back, and along what.
#include "core/autonomy/step_back.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

constexpr double kPatience = 2.0;  // [s]

// It has come 2 m along x, a quarter of a metre at a time, to `x` [m].
StepBack come_to(double x) {
  StepBack back;
  for (int k = 0; k <= 8; ++k) back.observe({x - 2.0 + 0.25 * k, 0.0, 0.0}, false, 0.05 * k);
  return back;
}

// Blocked at x [m] from `begin` on: after how long it is due [s]; negative: not within 20 s.
double due_after(StepBack& back, double x, double begin) {
  for (int k = 0; k <= 200; ++k) {
    back.observe({x, 0.0, 0.0}, true, begin + 0.1 * k);
    if (back.due(kPatience, begin + 0.1 * k)) return 0.1 * k;
  }
  return -1.0;
}

TEST(StepBack, TwiceAtOnePlaceTheSecondTimeLater) {
  StepBack back = come_to(0.0);
  EXPECT_NEAR(due_after(back, 0.0, 10.0), kPatience, 0.11);
  back.begin({0.0, 0.0, 0.0});
  EXPECT_NEAR(due_after(back, 0.1, 50.0), 2.0 * kPatience, 0.11);
  back.begin({0.1, 0.0, 0.0});
  EXPECT_LT(due_after(back, 0.0, 90.0), 0.0);
}

TEST(StepBack, WhatFailsDoesNotCount) {
  StepBack back = come_to(0.0);
  for (double begin : {10.0, 50.0, 90.0}) {
    EXPECT_NEAR(due_after(back, 0.0, begin), kPatience, 0.11);
    back.begin({0.0, 0.0, 0.0});
    back.fail();
  }
}

TEST(StepBack, AnewElsewhere) {
  StepBack back = come_to(0.0);
  for (double x : {0.0, 0.1}) back.begin({x, 0.0, 0.0});
  EXPECT_LT(due_after(back, 2.9, 50.0), 0.0);  // 2.8 m from where it stood last
  back.observe({3.2, 0.0, 0.0}, false, 80.0);
  EXPECT_NEAR(due_after(back, 3.2, 90.0), kPatience, 0.11);
}

TEST(StepBack, NotWithoutPatienceNorFromWhereItBegan) {
  StepBack back = come_to(0.0);
  back.observe({0.0, 0.0, 0.0}, true, 10.0);
  EXPECT_FALSE(back.due(0.0, 100.0)) << "0 s: never";
  StepBack fresh;
  EXPECT_LT(due_after(fresh, 0.0, 0.0), 0.0) << "it has come from nowhere";
}

// The robot's own pose and those that it came from, the newest first: of 2 m 9.
TEST(StepBack, TheWayItHasCome) {
  const StepBack back = come_to(0.0);
  std::vector<Pose2> way;
  back.write_way_back({0.04, 0.0, 0.0}, way);
  ASSERT_EQ(way.size(), 10U);
  EXPECT_EQ(way.front().x, 0.04);
  for (std::size_t k = 1; k < way.size(); ++k) EXPECT_LT(way[k].x, way[k - 1].x) << k;
  EXPECT_NEAR(way.back().x, -2.0, 1e-9);
}

// 15 places are remembered, 3 m.
TEST(StepBack, ForgetsWhatIsFarBack) {
  StepBack back;
  for (int k = 0; k <= 1000; ++k) back.observe({0.25 * k, 0.0, 0.0}, false, 0.1 * k);
  std::vector<Pose2> way;
  back.write_way_back({250.0, 0.0, 0.0}, way);
  EXPECT_EQ(way.size(), 16U);
  EXPECT_NEAR(way.back().x, 246.5, 1e-9);  // 250 m less 14 steps
}

}  // namespace
}  // namespace hidwa_local_planner
