// SPDX-License-Identifier: BSD-3-Clause
// Distance grids against every pair of cells and against Dijkstra with a priority queue.
#include <gtest/gtest.h>

#include "core/distance/distance_grid.hpp"
#include "support/naive_distance.hpp"
#include "support/random.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::Random;
using test::Scene;

// Free, dear, inscribed, lethal and unknown cells at random; sources anywhere, on obstacles as well.
Scene random_map(Random& random, std::vector<Cell>& sources) {
  Scene scene;
  scene.size_x = random.integer(1, 40);
  scene.size_y = random.integer(1, 40);
  const double density = random.uniform(0.0, 0.6);
  for (int k = 0; k < scene.size_x * scene.size_y; ++k) {
    const bool something = random.chance(density);
    scene.costs.push_back(something ? random.pick<std::uint8_t>({100, 253, 254, 255}) : std::uint8_t{0});
  }
  sources.clear();
  for (int k = random.integer(1, 6); k > 0; --k) {
    sources.push_back({random.integer(0, scene.size_x - 1), random.integer(0, scene.size_y - 1)});
  }
  return scene;
}

TEST(DistanceTwin, L1) {
  Random random(21);
  DistanceGrids distances;
  std::vector<Cell> sources;
  for (int k = 0; k < 300; ++k) {
    const Scene scene = random_map(random, sources);
    distances.prepare(scene.grid(), MapGridDistance::l1);
    distances.set_sources(1, sources);
    const std::vector<int> naive = test::naive_l1(scene.grid(), sources);
    for (int j = 0; j < scene.size_y; ++j) {
      for (int i = 0; i < scene.size_x; ++i) {
        ASSERT_EQ(distances.units(1, {i, j}), naive[scene.grid().index({i, j})])
            << "map " << k << " cell " << i << " " << j;
      }
    }
  }
}

TEST(DistanceTwin, Geodesic) {
  Random random(22);
  DistanceGrids distances;
  std::vector<Cell> sources;
  int unreached = 0, blocked = 0;
  for (int k = 0; k < 300; ++k) {
    const Scene scene = random_map(random, sources);
    const std::vector<Cell> others(sources.begin(), sources.begin() + 1);
    distances.prepare(scene.grid(), MapGridDistance::geodesic);
    distances.set_sources(0, sources);
    distances.set_sources(2, others);
    const std::vector<int> naive = test::naive_geodesic(scene.grid(), sources);
    const std::vector<int> naive_others = test::naive_geodesic(scene.grid(), others);
    for (int j = 0; j < scene.size_y; ++j) {
      for (int i = 0; i < scene.size_x; ++i) {
        const int expected = naive[scene.grid().index({i, j})];
        ASSERT_EQ(distances.units(0, {i, j}), expected) << "map " << k << " cell " << i << " " << j;
        ASSERT_EQ(distances.units(2, {i, j}), naive_others[scene.grid().index({i, j})])
            << "map " << k << " cell " << i << " " << j;
        unreached += expected < 0;
        blocked += expected >= 0 && test::naive_blocks(scene.grid().at({i, j}));
      }
    }
  }
  EXPECT_GT(unreached, 50);  // both kinds did occur
  EXPECT_GT(blocked, 10000);
}

}  // namespace
}  // namespace hidwa_local_planner
