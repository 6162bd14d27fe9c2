// SPDX-License-Identifier: BSD-3-Clause
#include "sim/avoiding_operator.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "stand_in.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

/// The office and the way through it, made once.
class Office : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    map_ = std::make_shared<OccupancyMap>(load_map(HIDWA_MAPS_DIR "/office.yaml"));
    file_ = load_regions(HIDWA_MAPS_DIR "/office_regions.yaml");
    routes_ = std::make_unique<GridRoute>(*map_, RouteClearance(), goal());
  }
  static void TearDownTestSuite() {
    map_.reset();
    routes_.reset();
  }

  static Eigen::Vector2d goal() { return {file_.goal->x, file_.goal->y}; }

  static World make_world(double latency = 0.0) {
    WorldSetup setup;
    setup.map = map_;
    setup.regions = file_.regions;
    setup.footprint = circle_polygon(0.3, 16);
    setup.start = *file_.start;
    setup.limits.latency = latency;
    return World(setup);
  }

  static DriveResult drive_avoiding(World& world, const RobotHabits& robot, const RobotHabits& believed,
                                    std::uint64_t seed) {
    AvoidingOperator person(OperatorTraits(), believed, *map_, file_.regions, seed);
    return drive(
        world, *routes_, goal(), robot, person, [&](const Route& plan) { person.set_plan(plan); }, 400.0);
  }

  static std::shared_ptr<OccupancyMap> map_;
  static RegionsFile file_;
  static std::unique_ptr<GridRoute> routes_;
};

std::shared_ptr<OccupancyMap> Office::map_;
RegionsFile Office::file_;
std::unique_ptr<GridRoute> Office::routes_;

TEST_F(Office, TheAutonomyAloneCrossesRegions) {
  World world = make_world();
  AbsentOperator nobody;
  const DriveResult result = drive(
      world, *routes_, goal(), RobotHabits(), nobody, [](const Route&) {}, 400.0);
  EXPECT_TRUE(result.arrived);
  EXPECT_EQ(world.contacts(), 0);
  EXPECT_GE(world.regions().crossed(), 3);
  EXPECT_EQ(result.active, 0.0);
}

TEST_F(Office, ThePersonKeepsItOutOfAllRegions) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    World world = make_world();
    const DriveResult result = drive_avoiding(world, RobotHabits(), RobotHabits(), seed);
    EXPECT_TRUE(result.arrived) << seed;
    EXPECT_EQ(world.contacts(), 0) << seed;
    EXPECT_EQ(world.regions().crossed(), 0) << seed;
    // Help, not driving: some 4 regions of a few seconds each.
    EXPECT_GT(result.active, 4.0) << seed;
    EXPECT_LT(result.active, 0.3 * world.time()) << seed;
  }
}

TEST_F(Office, ARobotSomewhatOtherThanThoughtIsMasteredToo) {
  RobotHabits robot;
  robot.hold_time = 1.0;
  robot.pursuit = 0.4;
  robot.max_vel_theta = 0.9;
  World world = make_world(0.15);
  const DriveResult result = drive_avoiding(world, robot, RobotHabits(), 9);
  EXPECT_TRUE(result.arrived);
  EXPECT_EQ(world.contacts(), 0);
  EXPECT_EQ(world.regions().crossed(), 0);
}

TEST_F(Office, SameSeedSameDrive) {
  std::vector<double> sticks[2];
  for (std::vector<double>& s : sticks) {
    World world = make_world();
    s = drive_avoiding(world, RobotHabits(), RobotHabits(), 3).sticks;
  }
  EXPECT_EQ(sticks[0], sticks[1]);
}

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
