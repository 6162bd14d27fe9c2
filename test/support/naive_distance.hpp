// SPDX-License-Identifier: BSD-3-Clause
// Distances between cells, the slow way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
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
/// diagonally. Distances are small whole numbers, so a list of cells for each of them is the queue (Dial 1969).
template <typename Enter>
std::vector<int> naive_dijkstra(const GridView& grid, const std::vector<int>& from, const Enter& enter) {
  std::vector<std::vector<Cell>> queue;
  const auto put = [&queue](int distance, const Cell& cell) {
    const auto at = static_cast<std::size_t>(distance);
    if (queue.size() <= at) queue.resize(at + 1);
    queue[at].push_back(cell);
  };
  std::vector<int> done(grid.cell_count(), -1);
  for (int j = 0; j < grid.size_y; ++j) {
    for (int i = 0; i < grid.size_x; ++i) {
      if (from[grid.index({i, j})] >= 0) put(from[grid.index({i, j})], {i, j});
    }
  }
  for (std::size_t distance = 0; distance < queue.size(); ++distance) {
    for (std::size_t n = 0; n < queue[distance].size(); ++n) {
      const Cell cell = queue[distance][n];
      if (done[grid.index(cell)] >= 0) continue;
      done[grid.index(cell)] = static_cast<int>(distance);
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
          const Cell to{cell.i + di, cell.j + dj};
          if (!grid.contains(to) || done[grid.index(to)] >= 0 || !enter(to)) continue;
          put(static_cast<int>(distance) + (di != 0 && dj != 0 ? 7 : 5), to);
        }
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
