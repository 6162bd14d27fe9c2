// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/control/plan_window.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

// `metres` long along +x, a pose every 0.1 m.
std::vector<Pose2> straight(double metres) {
  std::vector<Pose2> plan;
  for (int i = 0; i <= static_cast<int>(std::lround(metres / 0.1)); ++i) plan.push_back({0.1 * i, 0.0, 0.0});
  return plan;
}

TEST(PlanWindow, ReachesAsFarAsAskedAlongThePlan) {
  PlanWindow window;
  window.set_plan(straight(10.0));
  const PlanWindow::Range range = window.around({4.03, 0.5, 0.0}, 1.0, 2.0);
  EXPECT_NEAR(window.progress(), 4.03, 1e-9);
  // From 3.03 to 6.03: poses 3.1 to 6.0.
  EXPECT_EQ(range.begin, 31u);
  EXPECT_EQ(range.end, 61u);
}

TEST(PlanWindow, ProgressNeverGoesBack) {
  PlanWindow window;
  window.set_plan(straight(10.0));
  window.around({4.0, 0.0, 0.0}, 1.0, 2.0);
  window.around({3.0, 0.0, 0.0}, 1.0, 2.0);
  EXPECT_NEAR(window.progress(), 4.0, 1e-9);
  double before = 0.0;
  for (int k = 0; k <= 100; ++k) {  // forward with a jitter of 0.3 m
    window.around({4.0 + 0.05 * k + (k % 2 == 0 ? 0.3 : 0.0), 0.2, 0.0}, 1.0, 2.0);
    EXPECT_GE(window.progress(), before);
    before = window.progress();
  }
  EXPECT_NEAR(before, 9.3, 1e-9);  // 4.0 + 5.0 + 0.3
}

// Outside of a corner the nearest place is the corner itself, 1 m along the plan; not where its leg would lead on.
TEST(PlanWindow, OutsideOfACornerItIsAtTheCorner) {
  PlanWindow window;
  window.set_plan({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}});
  window.around({1.2, -0.1, 0.0}, 1.0, 2.0);
  EXPECT_NEAR(window.progress(), 1.0, 1e-9);
  EXPECT_EQ(window.next_pose(), 1u);
}

TEST(PlanWindow, TheFirstQuerySearchesTheWholePlan) {
  PlanWindow window;
  window.set_plan(straight(30.0));
  window.around({25.0, 0.1, 0.0}, 1.0, 2.0);
  EXPECT_NEAR(window.progress(), 25.0, 1e-9);
}

TEST(PlanWindow, ALoopCannotPullToTheWrongBranch) {
  // Out 6 m, 0.4 m to the side, and back: the way back runs 0.4 m beside the way out.
  std::vector<Pose2> plan = straight(6.0);
  for (int i = 1; i <= 4; ++i) plan.push_back({6.0, 0.1 * i, M_PI / 2});
  for (int i = 1; i <= 60; ++i) plan.push_back({6.0 - 0.1 * i, 0.4, M_PI});
  PlanWindow window;
  window.set_plan(plan);
  window.around({0.0, 0.0, 0.0}, 1.0, 2.0);
  // The robot drifts to y = 0.3, nearer to the way back (0.1 m) than to the way out (0.3 m).
  for (int k = 0; k <= 50; ++k) {
    const double x = 0.05 * k;
    window.around({x, 0.3, 0.0}, 1.0, 2.0);
    ASSERT_NEAR(window.progress(), x, 1e-9);
  }
}

// The way back along y = 1 begins 2 m ahead, where the search for the nearest stretch ends; so far the robot may have
// come.
TEST(PlanWindow, AStretchThatBeginsWhereTheSearchEndsIsFound) {
  PlanWindow window;
  window.set_plan({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}});
  window.around({0.0, 0.0, 0.0}, 1.0, 2.0);
  window.around({0.0, 0.9, 0.0}, 1.0, 2.0);
  EXPECT_EQ(window.progress(), 2.0);
}

TEST(PlanWindow, AReplanStartsAnew) {
  PlanWindow window;
  window.set_plan(straight(10.0));
  window.around({8.0, 0.0, 0.0}, 1.0, 2.0);
  window.set_plan(straight(10.0));
  const PlanWindow::Range range = window.around({2.0, 0.0, 0.0}, 1.0, 2.0);
  EXPECT_NEAR(window.progress(), 2.0, 1e-9);
  EXPECT_EQ(range.begin, 10u);
}

TEST(PlanWindow, ShortPlansAreGivenWhole) {
  PlanWindow window;
  window.set_plan(straight(0.3));
  const PlanWindow::Range range = window.around({0.1, 0.0, 0.0}, 1.0, 2.0);
  EXPECT_EQ(range.begin, 0u);
  EXPECT_EQ(range.end, 4u);
}

TEST(PlanWindow, BeyondTheEndTheLastPoseRemains) {
  PlanWindow window;
  window.set_plan(straight(5.0));
  const PlanWindow::Range range = window.around({9.0, 0.0, 0.0}, 0.0, 2.0);
  EXPECT_EQ(range.begin, 50u);
  EXPECT_EQ(range.end, 51u);
}

TEST(PlanWindow, OnePoseAndNone) {
  PlanWindow window;
  window.set_plan({{3.0, 1.0, 0.5}});
  for (int k = 0; k < 3; ++k) {
    const PlanWindow::Range range = window.around({0.0, 0.0, 0.0}, 1.0, 2.0);
    EXPECT_EQ(range.begin, 0u);
    EXPECT_EQ(range.end, 1u);
  }
  window.set_plan({});
  EXPECT_TRUE(window.empty());
  const PlanWindow::Range none = window.around({0.0, 0.0, 0.0}, 1.0, 2.0);
  EXPECT_EQ(none.begin, none.end);
}

TEST(PlanWindow, RepeatedPosesDoNoHarm) {
  std::vector<Pose2> plan(5, Pose2{1.0, 0.0, 0.0});
  plan.push_back({2.0, 0.0, 0.0});
  PlanWindow window;
  window.set_plan(plan);
  const PlanWindow::Range range = window.around({1.5, 0.0, 0.0}, 1.0, 2.0);
  EXPECT_NEAR(window.progress(), 0.5, 1e-9);
  EXPECT_EQ(range.begin, 0u);
  EXPECT_EQ(range.end, 6u);
}

}  // namespace
}  // namespace hidwa_local_planner
