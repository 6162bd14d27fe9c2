// SPDX-License-Identifier: BSD-3-Clause
#include "sim/laser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "random_scene.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The slow and obvious way: the ray is cut with every occupied cell.
double naive_range(const OccupancyMap& map, double x, double y, double angle, double range_max) {
  const double direction[2] = {std::cos(angle), std::sin(angle)};
  const double start[2] = {x, y};
  double nearest = kInfinity;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (!map.occupied(column, row)) continue;
      const double low[2] = {map.origin_x + column * map.resolution, map.origin_y + row * map.resolution};
      double enter = 0.0;
      double leave = kInfinity;
      for (int axis = 0; axis < 2; ++axis) {
        const double a = (low[axis] - start[axis]) / direction[axis];
        const double b = (low[axis] + map.resolution - start[axis]) / direction[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
      }
      if (enter <= leave) nearest = std::min(nearest, enter);
    }
  }
  return nearest <= range_max ? nearest : kInfinity;
}

TEST(Ray, AgreesWithTheNaiveTwin) {
  Random random(11);
  int hits = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const OccupancyMap map = random_map(random, 70, 50, scene % 2 == 0 ? 0.003 : 0.05);
    const DistanceField distances = DistanceField::to_obstacles(map);
    for (int ray = 0; ray < 100; ++ray) {
      // Also from outside the map.
      const double x = uniform(random, -1.5, 2.4);
      const double y = uniform(random, 0.5, 3.4);
      const double angle = uniform(random, -10.0, 10.0);
      const double expected = naive_range(map, x, y, angle, 2.0);
      const double range = range_in(map, x, y, angle, 2.0);
      ASSERT_EQ(range_in(map, x, y, angle, 2.0, &distances), range) << "scene " << scene << " ray " << ray;
      if (std::isfinite(expected)) {
        ASSERT_NEAR(range, expected, 1e-9) << "scene " << scene << " ray " << ray;
        ++hits;
      } else {
        ASSERT_EQ(range, kInfinity) << "scene " << scene << " ray " << ray;
      }
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST(Ray, AlongTheAxesAndFromWithin) {
  OccupancyMap map = make_map(100, 100, 0.05);
  map.cells[map.index(60, 20)] = Cell::kOccupied;  // [3.00, 3.05] x [1.00, 1.05]
  EXPECT_NEAR(range_in(map, 1.02, 1.02, 0.0, 10.0), 3.00 - 1.02, 1e-12);
  EXPECT_NEAR(range_in(map, 4.52, 1.02, M_PI, 10.0), 4.52 - 3.05, 1e-12);
  EXPECT_NEAR(range_in(map, 3.02, 3.0, -M_PI / 2, 10.0), 3.0 - 1.05, 1e-9);
  EXPECT_EQ(range_in(map, 1.02, 1.02, 0.0, 1.9), kInfinity);
  EXPECT_EQ(range_in(map, 3.02, 1.02, 1.0, 10.0), 0.0);
}

TEST(Laser, BeamsOfAFullTurnDoNotRepeat) {
  LaserSpec spec;
  EXPECT_NEAR(spec.angle_increment(), 2.0 * M_PI / 720, 1e-12);
  spec.field_of_view = 1.5 * M_PI;
  spec.beams = 271;  // both ends: 270 intervals of one degree
  EXPECT_NEAR(spec.angle_increment(), M_PI / 180, 1e-12);
  EXPECT_NEAR(spec.angle_min(), -0.75 * M_PI, 1e-12);
}

TEST(Laser, RangesOutsideTheLimitsAreInfinite) {
  OccupancyMap map = make_map(200, 20, 0.05);
  for (int row = 0; row < 20; ++row) map.cells[map.index(100, row)] = Cell::kOccupied;  // a wall at x = 5.00
  LaserSpec spec;
  spec.beams = 4;  // back, right, front, left
  spec.range_max = 3.0;
  Random random(1);
  std::vector<float> ranges;
  scan(map, spec, {3.0, 0.5, 0.0}, random, ranges);
  ASSERT_EQ(ranges.size(), 4u);
  EXPECT_NEAR(ranges[2], 2.0, 1e-6);
  EXPECT_EQ(ranges[0], std::numeric_limits<float>::infinity());
  scan(map, spec, {4.97, 0.5, 0.0}, random, ranges);
  EXPECT_EQ(ranges[2], -std::numeric_limits<float>::infinity());
}

TEST(Laser, NoiseIsSeededAndAsWideAsSaid) {
  OccupancyMap map = make_map(200, 20, 0.05);
  for (int row = 0; row < 20; ++row) map.cells[map.index(100, row)] = Cell::kOccupied;
  LaserSpec spec;
  spec.beams = 1;
  spec.field_of_view = 0.0;
  spec.noise = 0.02;
  Random random(5);
  std::vector<float> ranges;
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kScans = 4000;
  for (int i = 0; i < kScans; ++i) {
    scan(map, spec, {3.0, 0.5, 0.0}, random, ranges);
    sum += ranges[0] - 2.0;
    squares += (ranges[0] - 2.0) * (ranges[0] - 2.0);
  }
  // Standard errors: 0.02 / sqrt(4000) = 0.0003 of the mean, 0.02 / sqrt(8000) = 0.0002 of the deviation.
  EXPECT_NEAR(sum / kScans, 0.0, 0.0012);
  EXPECT_NEAR(std::sqrt(squares / kScans), 0.02, 0.0009);
  Random again(5);
  scan(map, spec, {3.0, 0.5, 0.0}, again, ranges);
  EXPECT_NEAR(ranges[0], 2.0 + 0.02 * Random(5).normal(), 1e-6);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
