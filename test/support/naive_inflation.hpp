// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "support/scene.hpp"

namespace hidwa_local_planner::test {

/// costmap_2d's inflation, cell by cell: inscribed within `inscribed` [m] of a lethal cell's centre, then
/// 252 exp(-scaling (d - inscribed)) up to `radius` [m]. Unknown cells stay unknown.
inline void inflate(Scene& scene, double inscribed, double radius, double scaling) {
  const std::vector<std::uint8_t> before = scene.costs;
  const int reach = static_cast<int>(std::ceil(radius / scene.resolution));
  const GridView grid = scene.grid();
  for (int j = 0; j < scene.size_y; ++j) {
    for (int i = 0; i < scene.size_x; ++i) {
      if (before[grid.index({i, j})] != cost::kLethal) continue;
      for (int dj = -reach; dj <= reach; ++dj) {
        for (int di = -reach; di <= reach; ++di) {
          const Cell to{i + di, j + dj};
          if (!grid.contains(to) || before[grid.index(to)] >= cost::kLethal) continue;
          const double d = std::hypot(di, dj) * scene.resolution;
          if (d > radius) continue;
          const double value = d <= inscribed ? 253.0 : std::floor(252.0 * std::exp(-scaling * (d - inscribed)));
          scene.at(to) = std::max(scene.at(to), static_cast<std::uint8_t>(value));
        }
      }
    }
  }
}

}  // namespace hidwa_local_planner::test
