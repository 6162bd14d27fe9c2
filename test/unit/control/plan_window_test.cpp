// SPDX-License-Identifier: BSD-3-Clause
#include "control/plan_window.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

// `metres` long along +x, a pose every 0.1 m.
std::vector<Pose2> straight(double metres) {
  std::vector<Pose2> plan;
  for (int i = 0; i <= static_cast<int>(std::lround(metres / 0.1)); ++i) plan.push_back({0.1 * i, 0.0, 0.0});
  return plan;
}

PlanWindow window_on(std::vector<Pose2> plan) {
  PlanWindow window;
  window.set_plan(std::move(plan));
  return window;
}

struct Window {
  const char* name;
  std::vector<Pose2> plan;
  Pose2 robot;
  double behind, ahead;          // asked for [m]
  double progress;               // [m]
  std::size_t next, begin, end;  // the pose from there on, and the range
};

// The first query of a window, without the plan's order.
TEST(PlanWindow, ReachesAsFarAsAskedAlongThePlan) {
  const std::vector<Pose2> corner{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}};
  std::vector<Pose2> repeated(5, Pose2{1.0, 0.0, 0.0});
  repeated.push_back({2.0, 0.0, 0.0});
  const Window windows[] = {
      {"from 3.03 to 6.03: poses 3.1 to 6.0", straight(10.0), {4.03, 0.5, 0.0}, 1.0, 2.0, 4.03, 41, 31, 61},
      {"the first query searches the whole plan", straight(30.0), {25.0, 0.1, 0.0}, 1.0, 2.0, 25.0, 250, 240, 271},
      {"outside of a corner it is at the corner", corner, {1.2, -0.1, 0.0}, 1.0, 2.0, 1.0, 1, 0, 3},
      {"a short plan is given whole", straight(0.3), {0.1, 0.0, 0.0}, 1.0, 2.0, 0.1, 1, 0, 4},
      {"beyond the end the last pose remains", straight(5.0), {9.0, 0.0, 0.0}, 0.0, 2.0, 5.0, 50, 50, 51},
      {"one pose", {{3.0, 1.0, 0.5}}, {0.0, 0.0, 0.0}, 1.0, 2.0, 0.0, 0, 0, 1},
      {"repeated poses do no harm", repeated, {1.5, 0.0, 0.0}, 1.0, 2.0, 0.5, 5, 0, 6},
  };
  for (const Window& row : windows) {
    SCOPED_TRACE(row.name);
    PlanWindow window = window_on(row.plan);
    for (int k = 0; k < 3; ++k) {  // asked again it says the same
      window.advance(row.robot, nullptr);
      EXPECT_NEAR(window.progress(), row.progress, 1e-9);
      EXPECT_EQ(window.next_pose(), row.next);
      const PlanWindow::Range range = window.range(row.behind, row.ahead);
      EXPECT_EQ(range.begin, row.begin);
      EXPECT_EQ(range.end, row.end);
    }
  }
}

TEST(PlanWindow, OfNoPlanItIsEmpty) {
  PlanWindow window = window_on({});
  EXPECT_TRUE(window.empty());
  window.advance({}, nullptr);
  const PlanWindow::Range none = window.range(1.0, 2.0);
  EXPECT_EQ(none.begin, none.end);
}

TEST(PlanWindow, ProgressNeverGoesBackButWithANewPlan) {
  PlanWindow window = window_on(straight(10.0));
  window.advance({4.0, 0.0, 0.0}, nullptr);
  window.advance({3.0, 0.0, 0.0}, nullptr);
  EXPECT_NEAR(window.progress(), 4.0, 1e-9);
  double before = 0.0;
  for (int k = 0; k <= 100; ++k) {  // forward with a jitter of 0.3 m
    window.advance({4.0 + 0.05 * k + (k % 2 == 0 ? 0.3 : 0.0), 0.2, 0.0}, nullptr);
    EXPECT_GE(window.progress(), before);
    before = window.progress();
  }
  EXPECT_NEAR(before, 9.3, 1e-9);  // 4.0 + 5.0 + 0.3
  window.set_plan(straight(10.0));
  window.advance({2.0, 0.0, 0.0}, nullptr);
  EXPECT_NEAR(window.progress(), 2.0, 1e-9);
}

TEST(PlanWindow, ALoopCannotPullToTheWrongBranch) {
  // Out 6 m, 0.4 m to the side, and back: the way back runs 0.4 m beside the way out.
  std::vector<Pose2> plan = straight(6.0);
  for (int i = 1; i <= 4; ++i) plan.push_back({6.0, 0.1 * i, M_PI / 2});
  for (int i = 1; i <= 60; ++i) plan.push_back({6.0 - 0.1 * i, 0.4, M_PI});
  PlanWindow window = window_on(plan);
  window.advance({0.0, 0.0, 0.0}, nullptr);
  // The robot drifts to y = 0.3, nearer to the way back (0.1 m) than to the way out (0.3 m).
  for (int k = 0; k <= 50; ++k) {
    window.advance({0.05 * k, 0.3, 0.0}, nullptr);
    ASSERT_NEAR(window.progress(), 0.05 * k, 1e-9);
  }
}

// The way back along y = 1 begins 2 m ahead, where the search for the nearest stretch ends; so far the robot may have
// come.
TEST(PlanWindow, AStretchThatBeginsWhereTheSearchEndsIsFound) {
  PlanWindow window = window_on({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}});
  window.advance({0.0, 0.0, 0.0}, nullptr);
  window.advance({0.0, 0.9, 0.0}, nullptr);
  EXPECT_EQ(window.progress(), 2.0);
}

TEST(PlanWindow, PosesArePutInWhereAPlanHasNone) {
  // 1 m are seven parts of 0.143 m: the fewest that are no longer than 0.15 m. The heading is that of (0.6, 0.8).
  const std::vector<Pose2> dense = with_poses_between({{0.0, 0.0, 3.0}, {0.6, 0.8, 3.0}, {0.6, 0.94, 3.0}});
  ASSERT_EQ(dense.size(), 9u);
  for (std::size_t k = 0; k <= 7; ++k) {
    EXPECT_NEAR(dense[k].x, 0.6 * static_cast<double>(k) / 7.0, 1e-12);
    EXPECT_NEAR(dense[k].y, 0.8 * static_cast<double>(k) / 7.0, 1e-12);
    EXPECT_NEAR(dense[k].theta, k % 7 == 0 ? 3.0 : std::atan2(0.8, 0.6), 1e-12);
  }
  EXPECT_EQ(dense[8].y, 0.94);
}

TEST(PlanWindow, NothingIsPutInTwiceOrIntoADensePlan) {
  const auto same = [](const std::vector<Pose2>& a, const std::vector<Pose2>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const Pose2& p, const Pose2& q) { return p.x == q.x && p.y == q.y && p.theta == q.theta; });
  };
  EXPECT_TRUE(same(with_poses_between(straight(3.0)), straight(3.0)));
  for (const double length : {0.3, 1.0, 2.7, 10.0, 999.9, 4e5}) {
    const std::vector<Pose2> once =
        with_poses_between({{0.1, 0.2, 0.0}, {0.1 + 0.6 * length, 0.2 + 0.8 * length, 0.0}});
    EXPECT_TRUE(same(with_poses_between(once), once)) << length;
    EXPECT_LE(once.size(), 100002u);
  }
}

TEST(PlanWindow, PosesThatAreNoPlacesGetNoneBetween) {
  const double far = std::numeric_limits<double>::max();
  EXPECT_EQ(with_poses_between({{-far, 0.0, 0.0}, {far, 0.0, 0.0}}).size(), 2u);
  // A way of no finite length beside one that has one, however long.
  const double beyond = std::numeric_limits<double>::infinity();
  EXPECT_LE(with_poses_between({{beyond, 0.0, 0.0}, {0.0, 0.0, 0.0}, {1e300, 0.0, 0.0}}).size(), 100'004u);
  EXPECT_EQ(with_poses_between({{1.0, 2.0, 0.0}}).size(), 1u);
  EXPECT_TRUE(with_poses_between({}).empty());
}

TEST(PlanWindow, AHeadingThatIsNoNumberIsThePlansOwn) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Pose2> plan = with_poses_between({{0.0, 0.0, none}, {0.0, 0.1, none}, {0.1, 0.1, none}});
  ASSERT_EQ(plan.size(), 3u);
  EXPECT_EQ(plan[0].theta, 0.5 * M_PI);
  EXPECT_EQ(plan[1].theta, 0.5 * M_PI);
  EXPECT_EQ(plan[2].theta, 0.0);
  EXPECT_EQ(with_poses_between({{0.0, 0.0, none}}).front().theta, 0.0);
}

// Out along y = 0 to (5, 0), up, and back along y = `apart`.
std::vector<Pose2> hairpin(double apart) {
  return with_poses_between({{0.0, 0.0, 0.0}, {5.0, 0.0, 0.0}, {5.0, apart, 0.0}, {0.0, apart, 0.0}});
}

// 10 m x 10 m around the origin, free but for a wall.
class Floor {
 public:
  PlanGround ground() const { return {{costs_.data(), kCells, kCells, 0.05, -10.0, -10.0}, {}}; }
  void fill(double x0, double y0, double x1, double y1) {
    for (int j = 0; j < kCells; ++j) {
      for (int i = 0; i < kCells; ++i) {
        const double x = -10.0 + 0.05 * (i + 0.5), y = -10.0 + 0.05 * (j + 0.5);
        if (x > x0 && x < x1 && y > y0 && y < y1) costs_[static_cast<std::size_t>(j * kCells + i)] = cost::kLethal;
      }
    }
  }

 private:
  static constexpr int kCells = 400;
  std::vector<std::uint8_t> costs_ = std::vector<std::uint8_t>(kCells * kCells, cost::kFree);
};

const PlanOrder kOrder{0.25, false};
const PlanOrder kSteered{0.25, true};

struct Walker {
  explicit Walker(std::vector<Pose2> plan) { window.set_plan(std::move(plan)); }
  PlanWindow::Range at(const Pose2& robot, const PlanOrder& order = kOrder) {
    window.advance(robot, &order);
    window.find_turn(3.0, order, floor.ground());
    return window.range(1.0, 3.0);
  }
  PlanWindow window;
  Floor floor;
};

// The first place that comes near to one before it, twice as near as along the plan, is 0.15 m beyond the turn's second
// corner: 0.3 m apart, and 0.15 + 0.3 + 0.15 = 0.6 m along the plan. 3 m before that is x = 2.45; between poses that
// are 0.15 m apart it is found up to 0.15 m later.
TEST(PlanWindow, EndsWhereThePlanTurnsBackUntilTheRobotIsThere) {
  Walker walker(hairpin(0.3));
  walker.at({0.0, 0.0, 0.0});
  for (double x = 0.0; x < 4.75; x += 0.05) {
    const PlanWindow::Range range = walker.at({x, 0.0, 0.0});
    ASSERT_NEAR(walker.window.progress(), x, 1e-9);
    ASSERT_TRUE(x < 2.65 || range.turns_back) << x;
    ASSERT_TRUE(x > 2.4 || !range.turns_back) << x;
    if (!range.turns_back) continue;
    for (std::size_t k = range.begin; k < range.end; ++k) ASSERT_LE(walker.window.plan()[k].y, 0.15 + 1e-9);
  }
  EXPECT_NEAR(walker.window.turn().x, 5.0, 1e-9);
  EXPECT_NEAR(walker.window.turn().y, 0.15, 0.01);
  // Reached within 0.7 of the tolerance: 0.175 m.
  const PlanWindow::Range after = walker.at({4.95, 0.15, 1.57});
  EXPECT_FALSE(after.turns_back);
  walker.at({4.5, 0.3, 3.14});
  const PlanWindow::Range back = walker.at({4.3, 0.3, 3.14});
  EXPECT_NEAR(walker.window.progress(), 5.0 + 0.3 + 0.7, 1e-9);
  for (std::size_t k = back.begin; k < back.end; ++k) EXPECT_GE(walker.window.plan()[k].y, 0.1);
}

TEST(PlanWindow, TurnsThatAreWideAreNone) {
  // 1.6 m apart: the way along the plan is twice that with 0.8 m of both lanes, 3.2 m. No window of 3 m holds it.
  Walker walker(hairpin(1.6));
  for (double x = 0.0; x < 5.0; x += 0.05) EXPECT_FALSE(walker.at({x, 0.0, 0.0}).turns_back);
}

// Between the lanes stands a wall, as far as to the turn or 1 m short of it. The way round is 1.2 m from 0.3 m before
// the first corner: beyond the shorter wall, and within 3 m from x = 2.9 on.
TEST(PlanWindow, TurnsBehindObstaclesAreNone) {
  Walker whole(hairpin(0.6)), part(hairpin(0.6));
  whole.floor.fill(-1.0, 0.25, 4.9, 0.35);
  part.floor.fill(-1.0, 0.25, 4.0, 0.35);
  for (double x = 0.0; x < 4.7; x += 0.05) {
    EXPECT_FALSE(whole.at({x, 0.0, 0.0}).turns_back);
    const bool turns_back = part.at({x, 0.0, 0.0}).turns_back;
    EXPECT_TRUE(x > 2.85 || !turns_back) << x;
    EXPECT_TRUE(x < 3.1 || turns_back) << x;
  }
}

// From x = 4.6 on all is blocked: the last free pose before it is no farther before it than poses are apart.
TEST(PlanWindow, ATurnInAnObstacleIsTheLastFreePlaceBeforeIt) {
  Walker walker(hairpin(0.3));
  for (double x = 0.0; x < 4.0; x += 0.05) walker.at({x, 0.0, 0.0});
  EXPECT_TRUE(walker.at({4.0, 0.0, 0.0}).turns_back);
  EXPECT_NEAR(walker.window.turn().x, 5.0, 1e-9);
  walker.floor.fill(4.6, -0.2, 5.2, 0.5);
  EXPECT_TRUE(walker.at({4.05, 0.0, 0.0}).turns_back);
  EXPECT_NEAR(walker.window.turn().x, 4.525, 0.076);
  EXPECT_EQ(walker.window.turn().y, 0.0);
}

// Out and back by the same way: the tip, although places before it are near each other sooner. Poses are 0.15 m apart:
// it is found to half of that.
TEST(PlanWindow, TheTurnOfASpikeIsItsTip) {
  Walker walker(with_poses_between({{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}));
  for (double x = 0.0; x < 2.0; x += 0.05) walker.at({x, 0.0, 0.0});
  ASSERT_TRUE(walker.at({2.0, 0.0, 0.0}).turns_back);
  EXPECT_NEAR(walker.window.turn().x, 3.0, 0.075 + 1e-9);
}

TEST(PlanWindow, ARobotThatIsStuckGivesTheTurnUp) {
  Walker walker(hairpin(0.3));
  for (double x = 0.0; x < 4.0; x += 0.05) walker.at({x, 0.0, 0.0});
  walker.window.give_way();
  EXPECT_FALSE(walker.at({4.0, 0.0, 0.0}).turns_back);
}

// A plan that ends where it begins: both its ends are at the robot.
TEST(PlanWindow, OfSeveralPlacesTheFirstOneCounts) {
  std::vector<Pose2> square =
      with_poses_between({{0.1, 0.0, 0.0}, {2.0, 0.0, 0.0}, {2.0, 2.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 0.0}});
  Walker walker(square);
  walker.at({0.0, 0.0, 0.0});
  EXPECT_EQ(walker.window.progress(), 0.0);
  EXPECT_FALSE(walker.window.leads_to_end(0.25));
  Walker blind(square);
  blind.window.advance({0.0, 0.0, 0.0}, nullptr);
  EXPECT_NEAR(blind.window.progress(), 7.9, 1e-9);
}

TEST(PlanWindow, APlanToTheSameGoalGoesOnWhereAsMuchIsLeft) {
  Walker walker(hairpin(0.2));
  for (double x = 0.0; x <= 5.0; x += 0.05) walker.at({x, 0.0, 0.0});
  for (double x = 5.0; x >= 3.0; x -= 0.05) walker.at({x, 0.2, 3.14});
  ASSERT_NEAR(walker.window.progress(), 7.2, 0.1);
  walker.window.replace_plan(hairpin(0.2));  // the whole of it once more
  walker.at({3.0, 0.1, 3.14});
  EXPECT_NEAR(walker.window.progress(), 7.2, 0.1);
  walker.window.set_plan(hairpin(0.2));  // to a new goal
  walker.at({3.0, 0.1, 3.14});
  EXPECT_NEAR(walker.window.progress(), 3.0, 0.1);
}

TEST(PlanWindow, WhoSteersPassesWhatLiesBefore) {
  Walker walker(hairpin(0.6));
  for (double x = 0.0; x <= 3.0; x += 0.05) walker.at({x, 0.0, 0.0});
  walker.at({3.0, 0.5, 1.57}, kSteered);  // it looks across: it may be on either lane
  EXPECT_NEAR(walker.window.progress(), 3.0, 0.1);
  walker.at({3.0, 0.5, 3.14}, kOrder);  // nobody steers
  EXPECT_NEAR(walker.window.progress(), 3.0, 0.1);
  walker.at({3.0, 0.5, 3.14}, kSteered);
  EXPECT_NEAR(walker.window.progress(), 5.0 + 0.6 + 2.0, 0.1);
}

TEST(PlanWindow, WhoSteersAsideOnTheirLanePassNothing) {
  Walker walker(hairpin(0.3));
  for (double x = 0.0; x <= 3.0; x += 0.05) {
    walker.at({x, 0.25, 0.5}, kSteered);
    EXPECT_NEAR(walker.window.progress(), x, 1e-9);
  }
}

TEST(PlanWindow, LeadsToItsEndOnceTheRestIsNear) {
  Walker walker(straight(3.0));
  walker.at({2.4, 0.0, 0.0});
  EXPECT_FALSE(walker.window.leads_to_end(0.25));
  walker.at({2.6, 0.0, 0.0});
  EXPECT_TRUE(walker.window.leads_to_end(0.25));
  Walker near({{0.0, 0.0, 0.0}, {0.2, 0.0, 0.0}, {0.0, 0.2, 0.0}, {-0.2, 0.0, 0.0}, {0.0, 0.0, 0.0}});
  near.at({0.0, 0.0, 0.0});
  EXPECT_TRUE(near.window.leads_to_end(0.25));   // all of it is within 0.25 m
  EXPECT_FALSE(near.window.leads_to_end(0.15));  // its 0.97 m lead out of 0.15 m
}

}  // namespace
}  // namespace hidwa_local_planner
