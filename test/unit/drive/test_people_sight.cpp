// SPDX-License-Identifier: BSD-3-Clause
#include "drive/people_sight.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "drive/drive.hpp"
#include "drive/outline.hpp"
#include "drive/rolling_grid.hpp"
#include "sim/key_frames.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

sim::OccupancyMap map_with_wall() {
  sim::OccupancyMap map = sim::make_map(200, 200, 0.05, -5.0, -5.0);
  for (int column = 0; column < map.width; ++column) map.cells[map.index(column, 190)] = sim::Cell::kOccupied;
  return map;
}

sim::Mover mover(std::uint32_t id, double x, double y) {
  sim::Mover m;
  m.id = id;
  m.position = {x, y};
  m.velocity = {1.0, 0.5};
  m.radius = 0.4;
  return m;
}

TEST(PeopleSight, TellsTheTruthInTheCostmapsFrame) {
  const sim::OccupancyMap map = map_with_wall();
  const PeopleSight sight(map);
  // The map's frame is turned left by 90 degrees in the costmap's, and lies at (1, 2).
  const MovingObstacleEstimates told = sight.truth({mover(7, 3.0, 1.0)}, {1.0, 2.0, M_PI / 2.0});
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].id, 7U);
  EXPECT_NEAR((told[0].position - Point(1.0 - 1.0, 2.0 + 3.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((told[0].velocity - Point(-0.5, 1.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(told[0].radius, 0.4);
  EXPECT_EQ(told[0].age, 0.0);
  EXPECT_TRUE(told[0].points.empty());
}

TEST(PeopleSight, RemembersAPointWhileTheCostmapMarksItsCell) {
  const sim::OccupancyMap map = map_with_wall();
  PeopleSight sight(map);
  RollingGrid costs(4.0, 0.05);
  costs.follow(0.0, 0.0);
  const auto mark = [&](double x, double y, std::uint8_t value) {
    const Cell cell = costs.view().cell_at(x, y);
    costs.row(cell.j)[cell.i] = value;
  };
  mark(1.0, 0.52, cost::kLethal);
  mark(1.2, 0.52, cost::kInscribed);
  sight.add(3, {1.01, 0.53}, {1.01, 0.53});
  sight.add(3, {1.02, 0.54}, {1.02, 0.54});  // the same cell
  sight.add(3, {1.21, 0.53}, {1.21, 0.53});  // no longer marked
  sight.add(3, {9.0, 0.5}, {9.0, 0.5});      // beyond the costmap
  sight.add(3, {0.0, 4.45}, {1.01, 0.53});   // beside the wall, from y = 4.5 on
  sight.keep_marked(costs.view());
  const std::vector<Point> points = sight.truth({mover(3, 0.0, 0.0)}, {})[0].points;
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0], Point(1.01, 0.53));
  mark(1.0, 0.52, cost::kFree);
  sight.keep_marked(costs.view());
  EXPECT_TRUE(sight.truth({mover(3, 0.0, 0.0)}, {})[0].points.empty());
}

std::shared_ptr<sim::KeyFramePeople> somebody_along(const std::vector<sim::KeyFrame>& frames) {
  const std::vector<sim::KeyFrameTrack> tracks{sim::KeyFrameTrack(frames, sim::KeyMotion::linear)};
  return std::make_shared<sim::KeyFramePeople>(tracks, 0.3, 0.0);
}

// Somebody crosses 2.5 m ahead of a robot on its way through an open square.
DriveSetup crossing(Tracking tracking) {
  DriveSetup setup;
  setup.ground =
      std::make_shared<Ground>(std::make_shared<sim::OccupancyMap>(sim::make_map(240, 160, 0.05, -2.0, -4.0)));
  setup.goal = {6.0, 0.0, 0.0};
  setup.footprint = telepresence_footprint();
  setup.outline = circle_outline(0.3, 0.01);
  setup.parameters.cycle_budget = -1.0;
  setup.tracking = tracking;
  setup.time_limit = 40.0;
  // To and fro, 1 m/s, from 3 m to the right to 3 m to the left.
  setup.people = somebody_along({{0.0, {2.5, -3.0}}, {6.0, {2.5, 3.0}}, {12.0, {2.5, -3.0}}});
  return setup;
}

TEST(DriveAmongPeople, ThePlannerIsToldWhatIsTrueAndTheLaserSeesIt) {
  for (const Tracking tracking : {Tracking::none, Tracking::truth}) {
    std::size_t told = 0, marked = 0, points = 0;
    const auto watch = [&](const Cycle& cycle) {
      told += cycle.situation.moving_obstacles.size();
      for (const MovingObstacleEstimate& o : cycle.situation.moving_obstacles) {
        points += o.points.size();
        // Without slip of the odometry the costmap's frame differs from the map's by the start alone, here nothing.
        EXPECT_NEAR((o.position - cycle.world.movers()[0].position).norm(), 0.0, 1e-9);
        for (const Point& p : o.points) EXPECT_LT((p - o.position).norm(), 2.0);
      }
      for (int j = 0; j < cycle.grid.size_y; ++j) {
        for (int i = 0; i < cycle.grid.size_x; ++i) marked += cycle.grid.at({i, j}) == cost::kLethal;
      }
    };
    const DriveResult result = drive(crossing(tracking), watch);
    EXPECT_GT(marked, 100U);  // nothing else is there to be seen
    EXPECT_EQ(told, tracking == Tracking::none ? 0U : result.cycles);
    EXPECT_EQ(points > 0, tracking == Tracking::truth);
    EXPECT_LT(result.people.closest, 3.0);
    EXPECT_GT(result.people.encounters, 0);
  }
}

// The tracker's tracks reach the planner, with their age, and are of the one who is there.
TEST(DriveAmongPeople, TheTrackerFindsWhoCrosses) {
  std::size_t told = 0, near = 0;
  const auto watch = [&](const Cycle& cycle) {
    for (const MovingObstacleEstimate& o : cycle.situation.moving_obstacles) {
      ++told;
      EXPECT_GE(o.age, 0.0);
      EXPECT_LT(o.age, 0.051);  // scans come at 20 Hz
      near += (o.position - cycle.world.movers()[0].position).norm() < 0.3;
    }
  };
  const DriveResult result = drive(crossing(Tracking::laser), watch);
  EXPECT_GT(told, result.cycles / 4);
  EXPECT_GT(near, told * 9 / 10);
}

TEST(DriveAmongPeople, ATouchIsCountedAndEndsTheDriveWhereItShall) {
  // They run into the robot from behind at 3 m/s, wherever it goes.
  DriveSetup setup = crossing(Tracking::none);
  setup.people = somebody_along({{0.0, {-3.0, 0.0}}, {3.0, {6.0, 0.0}}, {4.0, {6.0, 2.0}}});
  setup.end_at_contact = true;
  const DriveResult result = drive(setup);
  EXPECT_EQ(result.ending, Ending::contact);
  EXPECT_EQ(result.contacts, 0);
  ASSERT_EQ(result.people.touches.size(), 1U);
  EXPECT_EQ(result.people.contacts_moving + result.people.contacts_at_rest, 1);
  EXPECT_FALSE(result.people.touches[0].by_robot);
  EXPECT_NEAR(result.people.touches[0].speed, 3.0, 1e-9);
}

TEST(DriveAmongPeople, WithNobodyThereNothingIsCounted) {
  DriveSetup setup = crossing(Tracking::truth);
  setup.people = nullptr;
  const DriveResult result = drive(setup);
  EXPECT_TRUE(result.arrived);
  EXPECT_EQ(result.people.encounters, 0);
  EXPECT_TRUE(std::isinf(result.people.closest));
  EXPECT_TRUE(result.people.touches.empty());
}

}  // namespace
}  // namespace drive
}  // namespace hidwa_local_planner
