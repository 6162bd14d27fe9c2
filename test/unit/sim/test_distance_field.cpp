// SPDX-License-Identifier: BSD-3-Clause
#include "sim/distance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "random_scene.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

TEST(DistanceField, AgreesWithTheNaiveTwin) {
  Random random(3);
  for (int scene = 0; scene < 20; ++scene) {
    const OccupancyMap map = random_map(random, 40, 31, scene % 2 == 0 ? 0.004 : 0.1);
    const DistanceField field = DistanceField::to_obstacles(map);
    for (int row = 0; row < map.height; ++row) {
      for (int column = 0; column < map.width; ++column) {
        double nearest = std::numeric_limits<double>::infinity();
        for (int r = 0; r < map.height; ++r) {
          for (int c = 0; c < map.width; ++c) {
            if (map.occupied(c, r)) nearest = std::min(nearest, 0.05 * std::hypot(c - column, r - row));
          }
        }
        if (std::isfinite(nearest)) {
          ASSERT_NEAR(field.at_cell(column, row), nearest, 1e-6) << scene << " " << column << " " << row;
        } else {
          ASSERT_GT(field.at_cell(column, row), 1000.0);
        }
      }
    }
  }
}

TEST(DistanceField, ToRegions) {
  const OccupancyMap map = make_map(100, 100, 0.1);
  const DistanceField field = DistanceField::to_regions(map, {{"square", {{2, 2}, {4, 2}, {4, 4}, {2, 4}}}});
  EXPECT_DOUBLE_EQ(field.at(3.0, 3.0), 0.0);
  // From the cell centre 6.05 to the last centre within, 3.95.
  EXPECT_NEAR(field.at(6.05, 3.05), 2.1, 1e-6);
  // Outside the map: as at its border.
  EXPECT_DOUBLE_EQ(field.at(-5.0, 3.05), field.at(0.05, 3.05));
}

TEST(DistanceField, WithoutRegionsItIsFarFromAny) {
  EXPECT_GT(DistanceField::to_regions(make_map(10, 10, 0.1), {}).at(0.5, 0.5), 1000.0);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
