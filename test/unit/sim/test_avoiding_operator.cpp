// SPDX-License-Identifier: BSD-3-Clause
#include "sim/avoiding_operator.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace sim {
namespace {

/// A hall with one region ahead of a straight plan along x at y = 5.
class Hall : public ::testing::Test {
 protected:
  OccupancyMap map_ = make_map(400, 200, 0.05);
  std::vector<Region> regions_{{"ahead", {{9, 4.4}, {10, 4.4}, {10, 5.5}, {9, 5.5}}}};
  AvoidingOperator person_{OperatorTraits(), RobotHabits(), map_, regions_, 1};

  void SetUp() override {
    Route plan;
    for (int i = 0; i <= 180; ++i) plan.emplace_back(1.0 + 0.1 * i, 5.0);
    person_.set_plan(plan);
  }

  Stick at(double time, double x) { return person_.update({time, {x, 5.0, 0.0}, {0.5, 0.0}}); }
};

TEST_F(Hall, NothingIsDoneFarFromRegions) {
  for (int i = 0; i < 100; ++i) EXPECT_EQ(at(0.05 * i, 2.0 + 0.025 * i).left, 0.0) << i;
}

TEST_F(Hall, TheStickMovesAReactionTimeAfterTheNeedIsSeen) {
  // From 7.0 the way ahead, 2.5 m, ends 0.5 m within the margin: steering is needed at once.
  EXPECT_EQ(at(0.0, 7.0).left, 0.0);
  double moved_at = -1.0;
  for (int i = 1; i <= 20 && moved_at < 0.0; ++i) {
    const double t = 0.05 * i;
    if (at(t, 7.0 + 0.5 * t).left != 0.0) moved_at = t;
  }
  EXPECT_NEAR(moved_at, 0.4, 0.051);
}

TEST_F(Hall, StickPositionsAreCoarse) {
  for (int i = 0; i < 60; ++i) {
    const double left = at(0.05 * i, 7.0 + 0.025 * i).left;
    EXPECT_NEAR(left / 0.05, std::round(left / 0.05), 1e-9);
    EXPECT_LE(std::abs(left), 1.0);
  }
}

TEST_F(Hall, TimeThatJumpsBackBeginsAnew) {
  for (int i = 0; i < 40; ++i) at(10.0 + 0.05 * i, 7.0 + 0.025 * i);
  EXPECT_EQ(at(0.0, 2.0).left, 0.0);
}

TEST(AvoidingOperator, WithoutPlanOrRegionsNothingIsDone) {
  const OccupancyMap map = make_map(100, 100, 0.1);
  AvoidingOperator no_plan(OperatorTraits(), RobotHabits(), map, {{"r", {{3, 3}, {4, 3}, {4, 4}}}}, 1);
  EXPECT_EQ(no_plan.update({0.0, {2.5, 3.2, 0.0}, {0.5, 0.0}}).left, 0.0);
  AvoidingOperator no_regions(OperatorTraits(), RobotHabits(), map, {}, 1);
  no_regions.set_plan({{1, 1}, {5, 1}});
  EXPECT_EQ(no_regions.update({0.0, {1.0, 1.0, 0.0}, {0.5, 0.0}}).left, 0.0);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
