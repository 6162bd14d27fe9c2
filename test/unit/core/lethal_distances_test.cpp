// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdint>
#include <cstdlib>
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

// Of all lethal cells of the window one by one.
int naive_square(const GridView& grid, const CellWindow& window, int i, int j) {
  int least = 1 << 20;
  for (int b = window.j0; b < window.j1; ++b) {
    for (int a = window.i0; a < window.i1; ++a) {
      if (grid.at({a, b}) == cost::kLethal) least = std::min(least, (a - i) * (a - i) + (b - j) * (b - j));
    }
  }
  return least;
}

bool all_free(const GridView& grid, int i0, int i1, int j) {
  for (int i = i0; i < i1; ++i) {
    if (grid.at({i, j}) != cost::kFree) return false;
  }
  return true;
}

TEST(LethalDistances, AreThoseToEachLethalCell) {
  Random random(1);
  LethalDistances distances;
  int exact = 0, left_out = 0;
  for (int k = 0; k < 1000; ++k) {
    const Map map = random_map(random);
    const int i0 = random.integer(0, map.view.size_x - 1), j0 = random.integer(0, map.view.size_y - 1);
    const CellWindow window{i0, random.integer(i0 + 1, map.view.size_x), j0, random.integer(j0 + 1, map.view.size_y)};
    const int reach = random.pick({1, 4, 20, LethalDistances::kMost});
    distances.begin(window, reach);
    std::vector<Cell> around;
    for (int n = random.integer(0, 3); n > 0; --n) {
      around.push_back({random.integer(window.i0, window.i1 - 1), random.integer(window.j0, window.j1 - 1)});
      distances.want_around(around.back());
    }
    distances.measure(map.view);
    for (int strip = 0; strip < distances.strips(); ++strip) {
      const int from = window.i0 + strip * LethalDistances::kColumns;
      const int to = std::min(from + LethalDistances::kColumns, window.i1);
      for (int j = window.j0; j < window.j1; ++j) {
        const LethalDistances::Square* row = distances.row(strip, j);
        const bool wanted = std::any_of(around.begin(), around.end(), [&](const Cell& cell) {
          return std::abs(cell.j - j) <= reach && cell.i - reach < to && cell.i + reach >= from;
        });
        ASSERT_EQ(row != nullptr, wanted && !all_free(map.view, from, to, j));
        left_out += row == nullptr ? 1 : 0;
        for (int i = from; row != nullptr && i < to; ++i) {
          const int square = naive_square(map.view, window, i, j);
          ASSERT_EQ(std::min<int>(row[i - from], reach * reach + 1), std::min(square, reach * reach + 1))
              << i << " " << j;
          exact += square <= reach * reach ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(exact, 10000);
  EXPECT_GT(left_out, 100);
}

}  // namespace
}  // namespace hidwa_local_planner
