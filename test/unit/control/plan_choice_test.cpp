// SPDX-License-Identifier: BSD-3-Clause
#include "control/plan_choice.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "control/enclosed_obstacle.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner::control {
namespace {

// 8 m x 8 m around the origin, in cells of 0.1 m.
struct Map {
  std::vector<std::uint8_t> costs = std::vector<std::uint8_t>(80 * 80, cost::kFree);
  GridView grid{costs.data(), 80, 80, 0.1, -4.0, -4.0};
  void set(double x, double y, std::uint8_t cost) { costs[grid.index(grid.cell_at(x, y))] = cost; }
  void pillar(double x, double y) {
    for (int i = -2; i <= 2; ++i) {
      for (int j = -2; j <= 2; ++j) set(x + 0.1 * i, y + 0.1 * j, cost::kLethal);
    }
  }
};

// From (0, 0) by way of (1.5, y) to (3, 0), a pose every 2 cm or so.
std::vector<Pose2> round(double y) {
  std::vector<Pose2> plan;
  for (int k = 0; k <= 150; ++k) {
    const double x = 0.02 * k;
    plan.push_back({x, y * (1.0 - std::abs(x - 1.5) / 1.5), 0.0});
  }
  return plan;
}

class PlanChoiceTest : public testing::Test {
 protected:
  PlanChoiceTest() { map_.pillar(1.5, 0.0); }
  bool prefers(const std::vector<Pose2>& followed, double now, bool autonomous = true) {
    return choice_.prefers_offer({{0.0, 0.0, 0.0}, {}, map_.grid, followed, now, autonomous}, parameters_);
  }
  Map map_;
  PlanChoice choice_;
  Parameters parameters_;
  const std::vector<Pose2> left_ = round(0.8), right_ = round(-0.8);
};

TEST_F(PlanChoiceTest, APlanRoundTheOtherSideWaitsForItsTime) {
  choice_.offer(right_);
  EXPECT_FALSE(prefers(left_, 10.0));
  EXPECT_FALSE(prefers(left_, 10.0 + 0.99 * parameters_.plan_hysteresis_time));
  choice_.offer(right_);  // as a host that plans every second does
  EXPECT_TRUE(prefers(left_, 10.0 + parameters_.plan_hysteresis_time));
  EXPECT_EQ(choice_.take().size(), right_.size());
  EXPECT_FALSE(choice_.offers());
}

TEST_F(PlanChoiceTest, APlanOnTheSameSideIsFollowedAtOnceAndEndsTheWaiting) {
  choice_.offer(right_);
  EXPECT_FALSE(prefers(left_, 10.0));
  choice_.offer(round(0.7));
  EXPECT_TRUE(prefers(left_, 11.0));
  choice_.take();
  choice_.offer(right_);
  EXPECT_FALSE(prefers(left_, 12.0));
  EXPECT_FALSE(prefers(left_, 12.0 + 0.99 * parameters_.plan_hysteresis_time));  // counted from 12 s on
}

TEST_F(PlanChoiceTest, WhatIsClearlyCheaperIsFollowedAtOnce) {
  // By (1.5, 2): 2 hypot(1.5, 2) = 5 m. By (1.5, -y): 2 hypot(1.5, y) < 0.8 x 5 m from y < 1.323 on.
  const std::vector<Pose2> followed = round(2.0);
  choice_.offer(round(-1.34));
  EXPECT_FALSE(prefers(followed, 10.0));
  choice_.offer(round(-1.30));
  EXPECT_TRUE(prefers(followed, 10.1));
}

TEST_F(PlanChoiceTest, CostsOfCellsCount) {
  // Half of the way to the left leads through cells of cost 125: each metre there counts 1 + 0.8 x 125 / 50 = 3.
  for (int i = 0; i < 15; ++i) {
    for (int j = 1; j < 12; ++j) map_.set(0.05 + 0.1 * i, 0.05 + 0.1 * j, 125);
  }
  choice_.offer(right_);  // the same length, without costs: 3.4 m against 1.7 x 3 + 1.7 = 6.8 m
  EXPECT_TRUE(prefers(left_, 10.0));
}

TEST_F(PlanChoiceTest, NothingWaitsWhereTheOldPlanIsBlocked) {
  choice_.offer(right_);
  EXPECT_FALSE(prefers(left_, 10.0));
  map_.set(1.55, 0.75, cost::kInscribed);  // on the left way: a robot there touches something
  EXPECT_TRUE(prefers(left_, 10.05));
}

TEST_F(PlanChoiceTest, NorWhereSomethingStandsBetweenTwoOfItsPoses) {
  const std::vector<Pose2> coarse = {{0.0, 0.0, 0.0}, {1.5, 0.8, 0.0}, {3.0, 0.0, 0.0}};
  choice_.offer(right_);
  EXPECT_FALSE(prefers(coarse, 10.0));
  map_.set(2.25, 0.4, cost::kInscribed);  // half-way between the last two
  EXPECT_TRUE(prefers(coarse, 10.05));
}

// A metre of unknown cells counts as a free one. Both ways are 2 hypot(1.5, 0.8) = 3.4 m long.
TEST_F(PlanChoiceTest, UnknownCellsCostWhatFreeOnesDo) {
  for (int i = 0; i < 30; ++i) {
    for (int j = 1; j < 12; ++j) map_.set(0.05 + 0.1 * i, -0.35 - 0.1 * j, cost::kUnknown);
  }
  choice_.offer(right_);
  EXPECT_FALSE(prefers(left_, 10.0));
}

// Both lead round the pillar, then a way back to where the robot is, and its distance from their two ends is the same.
TEST_F(PlanChoiceTest, OfARoundTripTheWholeWayCounts) {
  const auto trip = [](double y) {
    return std::vector<Pose2>{{0.0, 0.0, 0.0},  {1.5, y, 0.0},    {3.0, 0.0, 0.0},
                              {3.0, -2.0, 0.0}, {0.0, -2.0, 0.0}, {0.0, 0.0, 0.0}};
  };
  choice_.offer(trip(-0.8));
  EXPECT_FALSE(prefers(trip(0.8), 10.0));
}

TEST_F(PlanChoiceTest, UnknownCellsBlockNothing) {
  map_.set(1.55, 0.75, cost::kUnknown);
  choice_.offer(right_);
  EXPECT_FALSE(prefers(left_, 10.0));
}

TEST_F(PlanChoiceTest, NothingWaitsForTheOperatorAfterAFailureOrInThePapersMethod) {
  choice_.offer(right_);
  EXPECT_TRUE(prefers(left_, 10.0, false));
  EXPECT_FALSE(prefers(left_, 10.0));
  choice_.give_way();
  EXPECT_TRUE(prefers(left_, 10.0));
  choice_.take();
  parameters_.method = Method::paper;
  choice_.offer(right_);
  EXPECT_TRUE(prefers(left_, 10.0));
}

TEST_F(PlanChoiceTest, TheFrameOfThePlansMayBeAnother) {
  // The plans' frame lies at (1, 2) in the costmap's and is turned by a right angle: (x, y) there is (1 - y, 2 + x)
  // here.
  const FrameTransform from_plan{{1.0, 2.0, 0.5 * M_PI}};
  const auto in_plan_frame = [&](std::vector<Pose2> plan) {
    for (Pose2& pose : plan) pose = from_plan.apply_inverse(pose);
    return plan;
  };
  const std::vector<Pose2> left = in_plan_frame(left_);
  choice_.offer(in_plan_frame(right_));
  EXPECT_FALSE(choice_.prefers_offer({{0.0, 0.0, 0.0}, from_plan, map_.grid, left, 10.0, true}, parameters_));
  choice_.offer(in_plan_frame(round(0.7)));
  EXPECT_TRUE(choice_.prefers_offer({{0.0, 0.0, 0.0}, from_plan, map_.grid, left, 10.0, true}, parameters_));
}

TEST_F(PlanChoiceTest, PlansThatLeaveTheMapOnTwoSidesOfAWallAreOnTwoSides) {
  // A wall from (1.5, 0) to the map's end; one plan leaves the map above it, one below.
  for (int i = 0; i < 25; ++i) map_.set(1.5 + 0.1 * i, 0.0, cost::kLethal);
  std::vector<Pose2> above, below;
  for (int k = 0; k <= 60; ++k) {
    above.push_back({0.1 * k, k > 10 ? 0.8 : 0.08 * k, 0.0});
    below.push_back({0.1 * k, k > 10 ? -0.8 : -0.08 * k, 0.0});
  }
  choice_.offer(below);
  EXPECT_FALSE(prefers(above, 10.0));
}

// Nobody has looked at the plan yet: no cell is asked for that cannot be counted.
TEST_F(PlanChoiceTest, APoseThatIsNoPlaceLiesOffTheMap) {
  std::vector<Pose2> followed = round(0.9);
  for (const double bad : {std::nan(""), HUGE_VAL, -1e300}) {
    std::vector<Pose2> plan = round(-0.9);
    plan.back().x = bad;
    choice_.offer(std::move(plan));
    EXPECT_FALSE(prefers(followed, 0.0));  // until its end the two lead round the pillar
    choice_.clear();
  }
  EXPECT_TRUE(map_.grid.holds({-4.0, 3.99}));
  EXPECT_FALSE(map_.grid.holds({-4.01, 0.0}));
  EXPECT_FALSE(map_.grid.holds({0.0, 4.0}));
  EXPECT_FALSE(map_.grid.holds({0.0, std::nan("")}));
}

TEST_F(PlanChoiceTest, IsRememberedWhole) {
  choice_.offer(right_);
  EXPECT_FALSE(prefers(left_, 10.0));
  Bytes bytes;
  ArchiveWriter write(bytes);
  write(choice_);
  PlanChoice other;
  ArchiveReader read(bytes);
  read(other);
  ASSERT_TRUE(read.complete());
  choice_ = other;
  EXPECT_FALSE(prefers(left_, 10.0 + 0.99 * parameters_.plan_hysteresis_time));
  EXPECT_TRUE(prefers(left_, 10.0 + parameters_.plan_hysteresis_time));
}

TEST(SameWay, PlansThatRunSideBySideLeadTheSameWay) {
  const auto shifted = [](double dy) {
    std::vector<Pose2> plan;
    for (int k = 0; k <= 200; ++k) plan.push_back({0.05 * k, dy, 0.0});
    return plan;
  };
  const std::vector<Pose2> followed = shifted(0.0);
  EXPECT_TRUE(same_way(followed, 0, shifted(0.14), 0.15));
  EXPECT_FALSE(same_way(followed, 0, shifted(0.16), 0.15));
  EXPECT_TRUE(same_way(followed, 0, shifted(0.25), 0.25));  // at the bound
  EXPECT_FALSE(same_way(followed, 0, round(0.8), 0.15));
  // The robot is 3 m along the plan; the fresh one begins there.
  std::vector<Pose2> fresh(followed.begin() + 60, followed.end());
  EXPECT_TRUE(same_way(followed, 60, fresh, 0.15));
  // What is farther than 6 m ahead does not count: 3 m + 6 m = 9 m.
  for (Pose2& pose : fresh) {
    if (pose.x > 9.2) pose.y = 1.0;
  }
  EXPECT_TRUE(same_way(followed, 60, fresh, 0.15));
  for (Pose2& pose : fresh) {
    if (pose.x > 8.8) pose.y = 1.0;
  }
  EXPECT_FALSE(same_way(followed, 60, fresh, 0.15));
  // A fresh plan may begin a metre ahead of the robot: its 6.5th metre lies beside the followed one's 7.5th.
  std::vector<Pose2> coarse;
  for (int k = 0; k <= 20; ++k) coarse.push_back({0.5 * k, 0.0, 0.0});
  EXPECT_TRUE(same_way(coarse, 0, {coarse.begin() + 2, coarse.end()}, 0.15));
  // No plan to compare with.
  EXPECT_FALSE(same_way({}, 0, fresh, 0.15));
}

// How often a closed line goes round a point: the sum of the angles under which it sees the line's edges.
int turns_round(const std::vector<Point>& line, const Point& p) {
  double sum = 0.0;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Point a = line[k] - p, b = line[(k + 1) % line.size()] - p;
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return static_cast<int>(std::lround(sum / (2.0 * M_PI)));
}

TEST(EnclosedObstacle, IsFoundAsBySummingAngles) {
  test::Random random(20261122);
  int enclosed = 0;
  for (int round = 0; round < 2000; ++round) {
    Map map;
    for (int k = 0; k < 12; ++k) {
      const double x = random.uniform(-3.9, 3.9), y = random.uniform(-3.9, 3.9);
      map.set(x, y, cost::kLethal);
    }
    std::vector<Point> line;
    const int corners = 3 + round % 9;
    for (int k = 0; k < corners; ++k) line.push_back(Point{random.uniform(-4.5, 4.5), random.uniform(-4.5, 4.5)});
    bool expected = false;
    for (int j = 0; j < 80; ++j) {
      for (int i = 0; i < 80; ++i) {
        if (map.grid.at({i, j}) == cost::kLethal && turns_round(line, map.grid.centre({i, j})) != 0) expected = true;
      }
    }
    EXPECT_EQ(encloses_obstacle(line, map.grid), expected) << round;
    enclosed += expected ? 1 : 0;
  }
  EXPECT_GT(enclosed, 500);
  EXPECT_LT(enclosed, 1900);
}

// The view is the middle half of a larger map: rows 20 to 59, y = -2 m to 2 m. What lies below and above it is not
// seen.
TEST(EnclosedObstacle, IsLookedForOnTheMapOnly) {
  const std::vector<Point> round{{-3.0, -3.5}, {3.0, -3.5}, {3.0, 3.5}, {-3.0, 3.5}};
  for (const double y : {-2.05, -1.95, 1.95, 2.05}) {
    Map map;
    map.set(0.05, y, cost::kLethal);
    const GridView part{map.costs.data() + map.grid.index({0, 20}), 80, 40, 0.1, -4.0, -2.0};
    EXPECT_TRUE(encloses_obstacle(round, map.grid)) << y;
    EXPECT_EQ(encloses_obstacle(round, part), std::abs(y) < 2.0) << y;
  }
}

TEST(EnclosedObstacle, NothingLiesInALineOfTwoPointsOrOnNoMap) {
  Map map;
  map.pillar(0.0, 0.0);
  EXPECT_FALSE(encloses_obstacle({{-1.0, 0.0}, {1.0, 0.0}}, map.grid));
  EXPECT_FALSE(encloses_obstacle({{-1.0, -1.0}, {1.0, -1.0}, {0.0, 1.0}}, GridView{}));
  EXPECT_TRUE(encloses_obstacle({{-1.0, -1.0}, {1.0, -1.0}, {0.0, 1.0}}, map.grid));
}

// Edges up and down in turn, 0.05 m apart: the line goes round x = -2.45, -2.35, ..., between its first two crossings
// of a row, its next two, and so on. Those from the 65th on, at x = 0.7, are not looked at.
TEST(EnclosedObstacle, IsLookedForAmongTheFirst64Crossings) {
  std::vector<Point> zigzag;
  zigzag.reserve(100);
  for (int k = 0; k < 100; ++k) zigzag.emplace_back(-2.5 + 0.05 * k, k % 2 == 0 ? -1.0 : 1.0);
  for (const double x : {-2.45, 0.65, 0.75}) {
    Map map;
    map.set(x, 0.05, cost::kLethal);
    EXPECT_EQ(encloses_obstacle(zigzag, map.grid), x < 0.7) << x;
  }
}

}  // namespace
}  // namespace hidwa_local_planner::control
