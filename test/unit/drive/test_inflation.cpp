// SPDX-License-Identifier: BSD-3-Clause
#include "drive/inflation.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "unit/sim/random_scene.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

using sim::uniform;

TEST(InflatedCost, IsThatOfCostmap2d) {
  EXPECT_EQ(inflated_cost(0.0, 0.3, 3.0), cost::kLethal);
  EXPECT_EQ(inflated_cost(0.05, 0.3, 3.0), cost::kInscribed);
  EXPECT_EQ(inflated_cost(0.3, 0.3, 3.0), cost::kInscribed);
  EXPECT_EQ(inflated_cost(0.301, 0.3, 3.0), 251);  // 252 exp(-0.003)
  EXPECT_EQ(inflated_cost(0.8, 0.3, 3.0), 56);     // 252 exp(-1.5)
  EXPECT_EQ(inflated_cost(5.0, 0.3, 3.0), cost::kFree);
}

// Every cell against every lethal one.
TEST(Inflation, AgreesWithTheNaiveTwin) {
  sim::Random random(13);
  for (int scene = 0; scene < 40; ++scene) {
    const double resolution = scene % 2 == 0 ? 0.05 : 0.08;
    const InflationSettings settings{uniform(random, 0.0, 1.2), uniform(random, 0.5, 12.0)};
    const double inscribed = uniform(random, 0.0, 0.5);
    RollingGrid obstacles(3.0, resolution), costs(3.0, resolution);
    std::vector<Cell> lethal;
    const int count = scene % 5 == 0 ? 0 : static_cast<int>(uniform(random, 1.0, 60.0));
    for (int k = 0; k < count; ++k) {
      const Cell cell{static_cast<int>(uniform(random, 0.0, obstacles.cells())),
                      static_cast<int>(uniform(random, 0.0, obstacles.cells()))};
      obstacles.row(cell.j)[cell.i] = cost::kLethal;
      lethal.push_back(cell);
    }
    Inflation inflation(settings, inscribed, resolution);
    inflation.inflate(obstacles, costs);
    inflation.inflate(obstacles, costs);                                     // what was there before does not matter
    const double reach = std::ceil(settings.inflation_radius / resolution);  // [cells]
    for (int j = 0; j < costs.cells(); ++j) {
      for (int i = 0; i < costs.cells(); ++i) {
        double nearest = 1e9;  // [cells]
        for (const Cell& cell : lethal) nearest = std::min(nearest, std::hypot(cell.i - i, cell.j - j));
        const int expected =
            nearest <= reach ? inflated_cost(nearest * resolution, inscribed, settings.cost_scaling_factor) : 0;
        ASSERT_EQ(costs.row(j)[i], expected) << "scene " << scene << " cell " << i << " " << j;
      }
    }
  }
}

}  // namespace
}  // namespace drive
}  // namespace hidwa_local_planner
