// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sim/contact.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

/// An empty hall of 10 x 5 m with a wall from x = 4.00 to 4.05; the robot is a square of 0.4 m at (2, 2.5),
/// heading for the wall.
WorldSetup hall() {
  auto map = std::make_shared<OccupancyMap>(make_map(200, 100, 0.05));
  for (int row = 0; row < 100; ++row) map->cells[map->index(80, row)] = Cell::kOccupied;
  WorldSetup setup;
  setup.map = map;
  setup.footprint = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};
  setup.start = {2.0, 2.5, 0.0};
  setup.limits.command_timeout = 0.0;
  return setup;
}

void drive(World& world, const Velocity& velocity, double seconds) {
  world.command(velocity);
  world.advance(seconds);
}

TEST(World, TravelStopsAtTheObstacle) {
  World world(hall());
  drive(world, {0.5, 0.0}, 3.0);
  EXPECT_EQ(world.contacts(), 0);
  drive(world, {0.5, 0.0}, 7.0);
  // The front, 0.2 m ahead, stops at 4.00: at 3.80, by less than 5 mm / 2^12 too deep.
  EXPECT_NEAR(world.pose().x, 3.8, 2e-6);
  EXPECT_EQ(world.velocity().v, 0.0);
  EXPECT_TRUE(world.in_contact());
  // One uninterrupted contact however long it pushes, and one that the pose shows.
  EXPECT_EQ(world.contacts(), 1);
  EXPECT_TRUE(overlaps_occupied(world.map(), transformed(world.footprint(), world.pose())));
  EXPECT_NEAR(world.distance(), 1.8, 2e-6);
}

TEST(World, DiscsAreObstaclesToo) {
  WorldSetup setup = hall();
  setup.discs = std::make_shared<DiscField>(std::vector<Eigen::Vector2d>{{3.0, 2.5}}, 0.075);
  World world(setup);
  drive(world, {0.5, 0.0}, 7.0);
  // The front, 0.2 m ahead, stops at 3.000 - 0.075.
  EXPECT_NEAR(world.pose().x, 3.0 - 0.075 - 0.2, 2e-6);
  EXPECT_EQ(world.contacts(), 1);
  setup.start.x = 2.9;
  EXPECT_THROW(World{setup}, std::invalid_argument);
}

TEST(World, ContactEndsWithTheOverlapAndMayComeAgain) {
  World world(hall());
  drive(world, {0.5, 0.0}, 10.0);
  drive(world, {-0.5, 0.0}, 0.01);
  EXPECT_FALSE(world.in_contact());
  drive(world, {-0.5, 0.0}, 1.0);
  // Ramp of 0.2 s and 0.05 m, then 0.81 s at 0.5.
  EXPECT_NEAR(world.pose().x, 3.8 - 0.05 - 0.5 * 0.81, 1e-5);
  drive(world, {0.5, 0.0}, 3.0);
  EXPECT_EQ(world.contacts(), 2);
}

TEST(World, TurnsOutWhereThatIsFree) {
  World world(hall());
  drive(world, {0.5, 0.0}, 10.0);
  // A square flat against the wall cannot turn: its corner would go deeper.
  drive(world, {0.0, 1.0}, 1.0);
  EXPECT_EQ(world.pose().theta, 0.0);
  EXPECT_EQ(world.contacts(), 1);
  // With a corner against it, it turns to the flat side. Diagonal 0.2828 m: contact at x = 3.7172.
  WorldSetup setup = hall();
  setup.start.theta = M_PI / 4;
  setup.start.y = 0.5;
  World cornered(setup);
  drive(cornered, {0.5, 0.0}, 10.0);
  EXPECT_EQ(cornered.contacts(), 1);
  EXPECT_NEAR(cornered.pose().x, 4.0 - 0.2 * std::sqrt(2.0), 1e-5);
  drive(cornered, {0.0, -1.0}, 0.5);
  EXPECT_FALSE(cornered.in_contact());
  EXPECT_LT(cornered.pose().theta, M_PI / 4 - 0.2);
}

TEST(World, StepsAreAtMostTenMilliseconds) {
  // A wall one cell thick, met at 50 m/s: 0.5 m a step would be too far for 50 ms, and 10 ms still see it
  // because the robot is 0.4 m long and the step stops within it.
  WorldSetup setup = hall();
  setup.limits.max_vel_x = 20.0;
  setup.limits.acc_lim_x = 1000.0;
  World world(setup);
  drive(world, {20.0, 0.0}, 0.3);
  EXPECT_EQ(world.contacts(), 1);
  EXPECT_NEAR(world.pose().x, 3.8, 1e-4);
}

TEST(World, TimeAndResultDoNotDependOnTheCall) {
  World fine(hall());
  World coarse(hall());
  for (World* world : {&fine, &coarse}) world->command({0.5, 0.3});
  for (int i = 0; i < 200; ++i) fine.advance(0.01);
  coarse.advance(2.0);
  EXPECT_NEAR(fine.time(), 2.0, 1e-9);
  EXPECT_NEAR(fine.pose().x, coarse.pose().x, 1e-12);
  EXPECT_NEAR(fine.pose().theta, coarse.pose().theta, 1e-12);
}

TEST(World, CountsRegionsAtTheFootprint) {
  WorldSetup setup = hall();
  setup.regions = {{"ahead", {{3, 2}, {3.5, 2}, {3.5, 3}, {3, 3}}},
                   {"aside", {{3, 2.8}, {3.5, 2.8}, {3.5, 3.5}, {3, 3.5}}}};
  World world(setup);
  // The front reaches 3.0 at x = 2.8: after 0.8 m, which takes 0.2 s + 0.75 / 0.5 = 1.7 s.
  drive(world, {0.5, 0.0}, 1.69);
  EXPECT_EQ(world.regions().crossed(), 0);
  drive(world, {0.5, 0.0}, 2.0);
  // The side is at 2.7: the second is not touched.
  EXPECT_EQ(world.regions().crossed(), 1);
}

TEST(World, BadSetupsAreRefused) {
  WorldSetup setup = hall();
  setup.start.x = 3.9;
  EXPECT_THROW(World{setup}, std::invalid_argument);
  setup = hall();
  setup.footprint.clear();
  EXPECT_THROW(World{setup}, std::invalid_argument);
  setup = hall();
  setup.map.reset();
  EXPECT_THROW(World{setup}, std::invalid_argument);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
