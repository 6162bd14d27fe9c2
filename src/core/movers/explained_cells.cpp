// SPDX-License-Identifier: BSD-3-Clause
#include "core/movers/explained_cells.hpp"

#include <algorithm>
#include <cmath>

#include "core/movers/reachable_set.hpp"

namespace hidwa_local_planner {
namespace {

// Memory is kept for so many explained cells.
constexpr std::size_t kUsualCells = 4096;

}  // namespace

GridView ExplainedCells::without(const GridView& grid, const MovingObstacleEstimates& movers,
                                 const Parameters& parameters) {
  reserve(grid);
  find_explained(grid, movers, parameters);
  if (taken_.empty()) return grid;
  const int reach =
      static_cast<int>(std::min<double>(std::ceil(kFarthestCost / grid.resolution), LethalDistances::kMost));
  const CellWindow window = window_around(grid, reach);
  costs_.assign(grid.costs, grid.costs + grid.cell_count());
  GridView copy = grid;
  copy.costs = costs_.data();
  for (const Cell& cell : taken_) costs_[grid.index(cell)] = cost::kInscribed;  // at most: mend() says what
  before_.measure(grid, window, reach);
  after_.measure(copy, window, reach);
  learn_costs(grid, window, reach);
  mend(grid, window);
  return copy;
}

void ExplainedCells::reserve(const GridView& grid) {
  taken_.reserve(kUsualCells);
  costs_.reserve(grid.cell_count());
  for (LethalDistances* distances : {&before_, &after_}) distances->reserve(grid.size_x, grid.size_y);
}

void ExplainedCells::find_explained(const GridView& grid, const MovingObstacleEstimates& movers,
                                    const Parameters& parameters) {
  taken_.clear();
  for (const MovingObstacleEstimate& mover : movers) {
    const ReachableSet set(mover, parameters);
    for (const Point& point : mover.points) {
      const double i = (point.x() - grid.origin_x) / grid.resolution, j = (point.y() - grid.origin_y) / grid.resolution;
      if (!(i > -2.0 && j > -2.0 && i < grid.size_x + 2.0 && j < grid.size_y + 2.0)) continue;
      const Cell middle = grid.cell_at(point.x(), point.y());
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
          const Cell cell{middle.i + di, middle.j + dj};
          if (!grid.contains(cell) || grid.at(cell) != cost::kLethal) continue;
          if (set.covers(grid.centre(cell), 0.5 * grid.resolution)) taken_.push_back(cell);
        }
      }
    }
  }
  const auto before = [](const Cell& a, const Cell& b) { return a.j != b.j ? a.j < b.j : a.i < b.i; };
  const auto same = [](const Cell& a, const Cell& b) { return a.i == b.i && a.j == b.j; };
  std::sort(taken_.begin(), taken_.end(), before);
  taken_.erase(std::unique(taken_.begin(), taken_.end(), same), taken_.end());
}

// Whose cost may be that of what was taken.
CellWindow ExplainedCells::window_around(const GridView& grid, int reach) const {
  CellWindow window{grid.size_x, 0, grid.size_y, 0};
  for (const Cell& cell : taken_) {
    window.i0 = std::min(window.i0, cell.i);
    window.i1 = std::max(window.i1, cell.i + 1);
    window.j0 = std::min(window.j0, cell.j);
    window.j1 = std::max(window.j1, cell.j + 1);
  }
  return {std::max(0, window.i0 - reach), std::min(grid.size_x, window.i1 + reach), std::max(0, window.j0 - reach),
          std::min(grid.size_y, window.j1 + reach)};
}

// The largest cost that a cell at each distance has: that of inflation, or above.
void ExplainedCells::learn_costs(const GridView& grid, const CellWindow& window, int reach) {
  const int farthest = reach * reach;
  cost_at_.assign(static_cast<std::size_t>(farthest) + 1, cost::kFree);
  for (int j = window.j0; j < window.j1; ++j) {
    const LethalDistances::Square* before = before_.row(j);
    const std::uint8_t* costs = grid.costs + grid.index({window.i0, j});
    for (int k = 0; k < window.width(); ++k) {
      if (before[k] > farthest || costs[k] >= cost::kLethal) continue;
      std::uint8_t& known = cost_at_[static_cast<std::size_t>(before[k])];
      known = std::max(known, costs[k]);
    }
  }
  // No distance costs less than a larger one.
  for (std::size_t k = cost_at_.size() - 1; k > 0; --k) cost_at_[k - 1] = std::max(cost_at_[k - 1], cost_at_[k]);
}

void ExplainedCells::mend(const GridView& grid, const CellWindow& window) {
  for (int j = window.j0; j < window.j1; ++j) {
    const LethalDistances::Square *before = before_.row(j), *after = after_.row(j);
    std::uint8_t* costs = costs_.data() + grid.index({window.i0, j});
    for (int k = 0; k < window.width(); ++k) {
      if (before[k] == after[k] || costs[k] == cost::kUnknown) continue;
      const bool near = static_cast<std::size_t>(after[k]) < cost_at_.size();
      costs[k] = std::min(costs[k], near ? cost_at_[static_cast<std::size_t>(after[k])] : cost::kFree);
    }
  }
}

}  // namespace hidwa_local_planner
