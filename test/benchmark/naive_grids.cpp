// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/naive_grids.hpp"

#include <functional>
#include <queue>
#include <utility>

namespace hidwa_local_planner::test {
namespace {

using Queue = std::priority_queue<std::pair<int, int>, std::vector<std::pair<int, int>>, std::greater<>>;

// Settles the cells of `queue` (distance, index) and those reached from them that are blocked or not, as
// asked for. Others beside them go into `beyond`, where it is given.
void flood(const GridView& grid, std::vector<int>& distances, bool blocked, Queue& queue, Queue* beyond) {
  while (!queue.empty()) {
    const auto [distance, index] = queue.top();
    queue.pop();
    if (distance > distances[static_cast<std::size_t>(index)]) continue;  // found nearer since
    const Cell cell{index % grid.size_x, index / grid.size_x};
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        const Cell to{cell.i + di, cell.j + dj};
        if (!grid.contains(to)) continue;
        const int there = distance + (di != 0 && dj != 0 ? 7 : 5);
        const std::size_t at = grid.index(to);
        if (naive_grid_blocks(grid.at(to)) != blocked) {
          if (beyond != nullptr) beyond->emplace(there, static_cast<int>(at));
        } else if (distances[at] < 0 || there < distances[at]) {
          distances[at] = there;
          queue.emplace(there, static_cast<int>(at));
        }
      }
    }
  }
}

// Of the cells that were seen across the border, those that are nearest this way.
void enter(std::vector<int>& distances, Queue& beyond, Queue& queue) {
  for (; !beyond.empty(); beyond.pop()) {
    const auto [distance, index] = beyond.top();
    int& known = distances[static_cast<std::size_t>(index)];
    if (known >= 0) continue;
    known = distance;
    queue.emplace(distance, index);
  }
}

}  // namespace

std::vector<int> naive_grid(const GridView& grid, const std::vector<Cell>& sources) {
  std::vector<int> distances(grid.cell_count(), -1);
  Queue queue, beyond;
  for (const Cell& source : sources) {
    distances[grid.index(source)] = 0;
    queue.emplace(0, static_cast<int>(grid.index(source)));
  }
  flood(grid, distances, false, queue, &beyond);
  enter(distances, beyond, queue);
  flood(grid, distances, true, queue, nullptr);
  return distances;
}

}  // namespace hidwa_local_planner::test
