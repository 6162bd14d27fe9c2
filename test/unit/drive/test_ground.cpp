// SPDX-License-Identifier: BSD-3-Clause
#include "drive/ground.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "sim/contact.hpp"
#include "unit/sim/random_scene.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

using sim::uniform;

const sim::Polygon kOutline{{0.25, 0.05}, {0.0, 0.2}, {-0.2, 0.1}, {-0.15, -0.2}, {0.2, -0.15}};

// Points 1 mm apart on the outline, each against every occupied cell.
double naive_clearance(const sim::OccupancyMap& map, const sim::Pose& pose, double at_most) {
  const sim::Polygon placed = sim::transformed(kOutline, pose);
  double least = at_most;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (!map.occupied(column, row)) continue;
      const Eigen::Vector2d low(map.origin_x + column * map.resolution, map.origin_y + row * map.resolution);
      const Eigen::Vector2d high = low + Eigen::Vector2d(map.resolution, map.resolution);
      if (sim::overlaps_cell(placed, low.x(), low.y(), map.resolution)) return 0.0;
      for (std::size_t i = 0; i < placed.size(); ++i) {
        const Eigen::Vector2d side = placed[(i + 1) % placed.size()] - placed[i];
        const int parts = static_cast<int>(std::ceil(side.norm() / 0.001));
        for (int k = 0; k < parts; ++k) {
          const Eigen::Vector2d p = placed[i] + side * (static_cast<double>(k) / parts);
          least = std::min(least, (p - p.cwiseMax(low).cwiseMin(high)).norm());
        }
      }
    }
  }
  return least;
}

TEST(Ground, ClearanceAgreesWithTheNaiveTwin) {
  sim::Random random(23);
  int apart = 0;
  for (int scene = 0; scene < 12; ++scene) {
    const auto map =
        std::make_shared<sim::OccupancyMap>(sim::random_map(random, 60, 50, scene % 2 == 0 ? 0.002 : 0.01));
    const Ground ground(map);
    for (int k = 0; k < 12; ++k) {
      const sim::Pose pose{uniform(random, -1.5, 1.9), uniform(random, 0.5, 3.4), uniform(random, -4.0, 4.0)};
      const double at_most = uniform(random, 0.05, 1.0);
      const double expected = naive_clearance(*map, pose, at_most);
      ASSERT_NEAR(ground.clearance(kOutline, pose, at_most), expected, 1e-3) << "scene " << scene << " pose " << k;
      apart += expected > 0.0 && expected < at_most;
    }
  }
  EXPECT_GT(apart, 30);
}

TEST(Ground, DiscsStandInTheMap) {
  // A wall of the map 1 m ahead, a disc before it and one beside.
  auto map = std::make_shared<sim::OccupancyMap>(sim::make_map(40, 40, 0.1, -2.0, -2.0));
  for (int row = 0; row < 40; ++row) map->cells[map->index(30, row)] = sim::Cell::kOccupied;
  const auto discs = std::make_shared<sim::DiscField>(std::vector<Eigen::Vector2d>{{0.6, 0.0}, {0.0, 0.8}}, 0.1);
  const Ground ground(map, discs);
  EXPECT_NEAR(ground.range(0.0, 0.0, 0.0, 5.0), 0.5, 1e-9);         // 0.6 - 0.1
  EXPECT_NEAR(ground.range(0.0, -1.0, 0.0, 5.0), 1.0, 1e-9);        // the wall
  EXPECT_NEAR(ground.range(0.0, 0.0, 0.5 * M_PI, 5.0), 0.7, 1e-9);  // 0.8 - 0.1
  EXPECT_TRUE(std::isinf(ground.range(0.0, 0.0, M_PI, 5.0)));
  const sim::Polygon square{{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};
  EXPECT_NEAR(ground.clearance(square, {0.0, 0.0, 0.0}, 1.0), 0.3, 1e-9);   // 0.6 - 0.1 - 0.2
  EXPECT_NEAR(ground.clearance(square, {0.0, -1.5, 0.0}, 1.0), 0.8, 1e-9);  // 1.0 - 0.2 from the wall
  EXPECT_EQ(ground.clearance(square, {0.5, 0.0, 0.0}, 1.0), 0.0);
}

TEST(Ground, NeedsAMap) { EXPECT_THROW(Ground(nullptr), std::invalid_argument); }

TEST(Ground, TheRouteKeepsClearAsANavfnDoes) {
  const sim::RouteClearance clearance = navfn_clearance(0.3, 3.0);
  EXPECT_EQ(clearance.robot_radius, 0.3);
  EXPECT_EQ(clearance.cost_scaling_factor, 3.0);
  EXPECT_NEAR(clearance.weight, 0.8 * 252.0 / 50.0, 1e-12);  // of a neutral cost of 50
}

}  // namespace
}  // namespace drive
}  // namespace hidwa_local_planner
