// SPDX-License-Identifier: BSD-3-Clause
// Distances between cells, the slow way.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"

namespace hidwa_local_planner::test {

/// Manhattan distance [cells] to the nearest source: every cell against every source.
inline std::vector<int> naive_l1(const GridView& grid, const std::vector<Cell>& sources) {
  std::vector<int> distances;
  for (int j = 0; j < grid.size_y; ++j) {
    for (int i = 0; i < grid.size_x; ++i) {
      int best = -1;
      for (const Cell& s : sources) {
        const int d = std::abs(i - s.i) + std::abs(j - s.j);
        if (best < 0 || d < best) best = d;
      }
      distances.push_back(best);
    }
  }
  return distances;
}

inline bool naive_blocks(std::uint8_t value) { return value == 253 || value == 254; }

/// Dijkstra from cells with given distances (-1: none) through cells for which `enter` says so; 5 straight, 7
/// diagonally.
template <typename Enter>
std::vector<int> naive_dijkstra(const GridView& grid, const std::vector<int>& from, const Enter& enter) {
  using Entry = std::tuple<int, int, int>;  // distance, i, j
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  std::vector<int> done(grid.cell_count(), -1);
  for (int j = 0; j < grid.size_y; ++j) {
    for (int i = 0; i < grid.size_x; ++i) {
      if (from[grid.index({i, j})] >= 0) queue.emplace(from[grid.index({i, j})], i, j);
    }
  }
  while (!queue.empty()) {
    const auto [distance, i, j] = queue.top();
    queue.pop();
    if (done[grid.index({i, j})] >= 0) continue;
    done[grid.index({i, j})] = distance;
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        const Cell to{i + di, j + dj};
        if (!grid.contains(to) || done[grid.index(to)] >= 0 || !enter(to)) continue;
        queue.emplace(distance + (di != 0 && dj != 0 ? 7 : 5), to.i, to.j);
      }
    }
  }
  return done;
}

/// In fifths of a cell, -1 where there is no way: first through free cells, then from all reached ones into
/// blocked ones.
inline std::vector<int> naive_geodesic(const GridView& grid, const std::vector<Cell>& sources) {
  std::vector<int> seeds(grid.cell_count(), -1);
  for (const Cell& s : sources) seeds[grid.index(s)] = 0;
  const std::vector<int> reached = naive_dijkstra(grid, seeds, [&](Cell c) { return !naive_blocks(grid.at(c)); });
  return naive_dijkstra(grid, reached, [&](Cell c) { return naive_blocks(grid.at(c)); });
}

}  // namespace hidwa_local_planner::test
