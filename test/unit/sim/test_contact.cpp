// SPDX-License-Identifier: BSD-3-Clause
#include "sim/contact.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "random_scene.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

/// What is left of the polygon on the side of a line where axis * sign >= limit * sign.
Polygon cut(const Polygon& polygon, int axis, double limit, double sign) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a[axis] - limit);
    const double db = sign * (b[axis] - limit);
    if (da >= 0.0) result.push_back(a);
    if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) result.push_back(a + (b - a) * (da / (da - db)));
  }
  return result;
}

double area(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    sum += 0.5 * (a.x() * b.y() - b.x() * a.y());
  }
  return std::abs(sum);
}

/// The slow and obvious way: every cell of the map is cut with the polygon, and what remains is measured.
bool naive_overlap(const OccupancyMap& map, const Polygon& polygon) {
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (!map.occupied(column, row)) continue;
      const double x = map.origin_x + column * map.resolution;
      const double y = map.origin_y + row * map.resolution;
      const Polygon common =
          cut(cut(cut(cut(polygon, 0, x, 1), 0, x + map.resolution, -1), 1, y, 1), 1, y + map.resolution, -1);
      if (area(common) > 0.0) return true;
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

TEST(Contact, ACellWithinTheFootprintCounts) {
  OccupancyMap map = make_map(20, 20, 0.05);
  map.cells[map.index(10, 10)] = Cell::kOccupied;  // [0.50, 0.55] x [0.50, 0.55]
  EXPECT_TRUE(overlaps_occupied(map, transformed(circle_polygon(0.3), {0.52, 0.52, 0})));
}

TEST(Contact, UnknownCellsAreNoObstacles) {
  OccupancyMap map = make_map(20, 20, 0.05);
  map.cells.assign(map.cells.size(), Cell::kUnknown);
  EXPECT_FALSE(overlaps_occupied(map, transformed(circle_polygon(0.3), {0.5, 0.5, 0})));
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
