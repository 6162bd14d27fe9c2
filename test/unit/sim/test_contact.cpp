// SPDX-License-Identifier: BSD-3-Clause
#include "sim/contact.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "random_scene.hpp"
#include "support/naive_collision.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

/// The slow and obvious way: every cell of the map is cut with the polygon, and what remains is measured.
bool naive_overlap(const OccupancyMap& map, const Polygon& polygon) {
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (!map.occupied(column, row)) continue;
      const double x = map.origin_x + column * map.resolution;
      const double y = map.origin_y + row * map.resolution;
      if (test::naive_shared_area(polygon, x, y, map.resolution) > 0.0) return true;
    }
  }
  return false;
}

TEST(Contact, AgreesWithTheNaiveTwin) {
  const Polygon rectangle{{0.3, 0.1}, {-0.2, 0.1}, {-0.2, -0.15}, {0.3, -0.15}};
  const Polygon hook{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.0}, {0.0, 0.0}, {0.0, 0.2}, {-0.2, 0.2}};
  const Polygon tiny{{0.01, 0.0}, {-0.01, 0.01}, {-0.01, -0.01}};  // smaller than a cell
  Random random(7);
  int overlaps = 0;
  constexpr int kScenes = 3000;
  for (int i = 0; i < kScenes; ++i) {
    const OccupancyMap map = random_map(random, 30, 24, 0.01);
    const Polygon& shape = i % 3 == 0 ? rectangle : (i % 3 == 1 ? hook : tiny);
    // Also beyond the map's border.
    const Pose pose{uniform(random, -1.6, 0.5), uniform(random, 0.4, 2.2), uniform(random, -M_PI, M_PI)};
    const Polygon placed = transformed(shape, pose);
    const bool expected = naive_overlap(map, placed);
    ASSERT_EQ(overlaps_occupied(map, placed), expected) << "scene " << i;
    overlaps += expected ? 1 : 0;
  }
  // Neither answer is rare.
  EXPECT_GT(overlaps, kScenes / 10);
  EXPECT_LT(overlaps, kScenes * 9 / 10);
}

TEST(Contact, UnknownCellsAreNoObstacles) {
  OccupancyMap map = make_map(20, 20, 0.05);
  map.cells.assign(map.cells.size(), Cell::kUnknown);
  EXPECT_FALSE(overlaps_occupied(map, transformed(circle_polygon(0.3), {0.5, 0.5, 0})));
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
