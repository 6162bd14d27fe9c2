// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "core/movers/lethal_distances.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

using test::Random;

struct Map {
  std::vector<std::uint8_t> costs;
  GridView view;
};

Map random_map(Random& random) {
  Map map;
  map.view.size_x = random.integer(1, 90);
  map.view.size_y = random.integer(1, 50);
  map.costs.assign(map.view.cell_count(), cost::kFree);
  const double lethal = random.pick({0.0, 0.002, 0.02, 0.3}), other = random.pick({0.01, 0.5});
  for (std::uint8_t& value : map.costs) {
    if (random.chance(other)) value = random.pick<std::uint8_t>({1, 100, cost::kInscribed, cost::kUnknown});
    if (random.chance(lethal)) value = cost::kLethal;
  }
  map.view.costs = map.costs.data();
  return map;
}

// Of all lethal cells one by one.
int naive_square(const std::vector<Cell>& lethal, int i, int j) {
  int least = 1 << 20;
  for (const Cell& cell : lethal) {
    least = std::min(least, (cell.i - i) * (cell.i - i) + (cell.j - j) * (cell.j - j));
  }
  return least;
}

TEST(LethalDistances, AreThoseToEachLethalCell) {
  Random random(1);
  LethalDistances distances;
  int exact = 0, farther = 0;
  for (int k = 0; k < 1000; ++k) {
    const Map map = random_map(random);
    std::vector<Cell> lethal;
    for (int j = 0; j < map.view.size_y; ++j) {
      for (int i = 0; i < map.view.size_x; ++i) {
        if (map.view.at({i, j}) == cost::kLethal) lethal.push_back({i, j});
      }
    }
    const int i0 = random.integer(0, map.view.size_x - 1), j0 = random.integer(0, map.view.size_y - 1);
    const CellWindow window{i0, random.integer(i0 + 1, map.view.size_x), j0, random.integer(j0 + 1, map.view.size_y)};
    const int reach = random.pick({1, 4, 20, LethalDistances::kMost});
    distances.measure(map.view, window, reach);
    for (int j = window.j0; j < window.j1; ++j) {
      const LethalDistances::Square* row = distances.row(j);
      for (int i = window.i0; i < window.i1; ++i) {
        const int square = naive_square(lethal, i, j);
        ASSERT_EQ(std::min<int>(row[i - window.i0], reach * reach + 1), std::min(square, reach * reach + 1))
            << i << " " << j;
        ++(square <= reach * reach ? exact : farther);
      }
    }
  }
  EXPECT_GT(exact, 10000);
  EXPECT_GT(farther, 10000);
}

}  // namespace
}  // namespace hidwa_local_planner
