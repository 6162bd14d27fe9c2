// SPDX-License-Identifier: BSD-3-Clause
#include "drive/beams.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "unit/drive/naive_costmap.hpp"
#include "unit/sim/random_scene.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

using sim::uniform;

sim::LaserSpec four_beams() {
  sim::LaserSpec laser;
  laser.beams = 4;  // behind, right, ahead, left
  laser.range_max = 5.0;
  return laser;
}

void fill(RollingGrid& grid, std::uint8_t value) {
  for (int j = 0; j < grid.cells(); ++j) std::fill_n(grid.row(j), grid.cells(), value);
}

TEST(Project, BringsEndsIntoTheFrameOfTheSensor) {
  Beams beams;
  project({1.0F, 2.0F, 3.0F, 4.0F}, four_beams(), {10.0, 20.0, M_PI / 2.0}, beams);
  ASSERT_EQ(beams.ends.size(), 4u);
  EXPECT_TRUE(beams.origin.isApprox(Point(10.0, 20.0)));
  EXPECT_TRUE(beams.ends[0].isApprox(Point(10.0, 19.0), 1e-6));
  EXPECT_TRUE(beams.ends[1].isApprox(Point(12.0, 20.0), 1e-6));
  EXPECT_TRUE(beams.ends[2].isApprox(Point(10.0, 23.0), 1e-6));
  EXPECT_TRUE(beams.ends[3].isApprox(Point(6.0, 20.0), 1e-6));
}

TEST(Project, WhatMeetsNothingEndsAtFullRangeAndWhatIsNoRangeIsDropped) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Beams beams;
  project({kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN(), 5.0F}, four_beams(), {}, beams);
  ASSERT_EQ(beams.ends.size(), 1u);
  EXPECT_NEAR(beams.ends[0].norm(), 5.0, 1e-3);
  EXPECT_LT(beams.ends[0].norm(), 5.0);
  project({0.04F, 0.05F, 4.99F, 6.0F}, four_beams(), {}, beams);
  EXPECT_EQ(beams.ends.size(), 2u);  // range_min is 0.05
}

// Against lines whose cells are worked out one by one.
TEST(ClearAlong, FreesTheCellsOfTheLineUpToTheRange) {
  sim::Random random(7);
  for (int scene = 0; scene < 400; ++scene) {
    RollingGrid grid(2.0, 0.05);
    const double x = uniform(random, -3.0, 3.0), y = uniform(random, -3.0, 3.0);
    grid.follow(x, y);
    fill(grid, cost::kLethal);
    const GridView view = grid.view();
    Beams beams;
    beams.origin = {view.origin_x + uniform(random, 0.01, 1.99), view.origin_y + uniform(random, 0.01, 1.99)};
    beams.ends = {{view.origin_x + uniform(random, 0.01, 1.99), view.origin_y + uniform(random, 0.01, 1.99)}};
    const double range = uniform(random, 0.2, 3.0);
    clear_along(beams, range, grid);
    const Cell from = view.cell_at(beams.origin.x(), beams.origin.y());
    const Cell to = view.cell_at(beams.ends[0].x(), beams.ends[0].y());
    RollingGrid expected(2.0, 0.05);
    fill(expected, cost::kLethal);
    for (const auto& [i, j] : test::naive_line({from.i, from.j}, {to.i, to.j}, range / 0.05)) {
      expected.row(j)[i] = cost::kFree;
    }
    for (int j = 0; j < grid.cells(); ++j) {
      for (int i = 0; i < grid.cells(); ++i) ASSERT_EQ(grid.row(j)[i], expected.row(j)[i]) << scene;
    }
  }
}

TEST(ClearAlong, ASensorOutsideFreesNothing) {
  RollingGrid grid(2.0, 0.05);
  fill(grid, cost::kLethal);
  Beams beams;
  beams.origin = {-0.5, 1.0};
  beams.ends = {{1.5, 1.0}};
  clear_along(beams, 20.0, grid);
  for (int i = 0; i < grid.cells(); ++i) EXPECT_EQ(grid.row(20)[i], cost::kLethal);
}

TEST(ClearPolygon, APolygonPartlyOutsideFreesNothing) {
  RollingGrid grid(2.0, 0.1);
  fill(grid, cost::kLethal);
  clear_polygon({{-0.1, 0.5}, {1.0, 0.5}, {1.0, 1.0}}, grid);
  for (int j = 0; j < grid.cells(); ++j) {
    for (int i = 0; i < grid.cells(); ++i) ASSERT_EQ(grid.row(j)[i], cost::kLethal);
  }
}

}  // namespace
}  // namespace drive
}  // namespace hidwa_local_planner
