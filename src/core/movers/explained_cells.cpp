// SPDX-License-Identifier: BSD-3-Clause
#include "core/movers/explained_cells.hpp"

#include <algorithm>
#include <cmath>

#include "core/movers/reachable_set.hpp"

namespace hidwa_local_planner {
namespace {

// No lethal cell is so near [cells]; its square is still a number.
constexpr int kNone = 10000;

// Memory is kept for so many explained cells.
constexpr std::size_t kUsualCells = 4096;

bool is_lethal(const GridView& grid, int i, int j) { return grid.at({i, j}) == cost::kLethal; }

}  // namespace

GridView ExplainedCells::without(const GridView& grid, const MovingObstacleEstimates& movers) {
  reserve(grid);
  find_explained(grid, movers);
  if (taken_.empty()) return grid;
  const int reach = static_cast<int>(std::ceil(kFarthestCost / grid.resolution));
  const Window window = window_around(grid, reach);
  costs_.assign(grid.costs, grid.costs + grid.cell_count());
  GridView copy = grid;
  copy.costs = costs_.data();
  measure(grid, window, reach, before_);
  learn_costs(grid, window, reach);
  for (const Cell& cell : taken_) costs_[grid.index(cell)] = cost::kInscribed;  // at most: mend() says what
  measure(copy, window, reach, after_);
  mend(grid, window);
  return copy;
}

void ExplainedCells::reserve(const GridView& grid) {
  taken_.reserve(kUsualCells);
  costs_.reserve(grid.cell_count());
  for (std::vector<int>* values : {&rows_, &before_, &after_}) values->reserve(grid.cell_count());
}

void ExplainedCells::find_explained(const GridView& grid, const MovingObstacleEstimates& movers) {
  taken_.clear();
  for (const MovingObstacleEstimate& mover : movers) {
    // What its disc does not cover is not explained by it.
    const double farthest = mover.radius + ReachableSet::kDeviations * mover.position_deviation +
                            mover.velocity.norm() * mover.age + 2.0 * grid.resolution;
    for (const Point& point : mover.points) {
      if (!((point - mover.position).norm() <= farthest)) continue;
      const double i = (point.x() - grid.origin_x) / grid.resolution, j = (point.y() - grid.origin_y) / grid.resolution;
      if (!(i > -2.0 && j > -2.0 && i < grid.size_x + 2.0 && j < grid.size_y + 2.0)) continue;
      const Cell middle = grid.cell_at(point.x(), point.y());
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
          const Cell cell{middle.i + di, middle.j + dj};
          if (grid.contains(cell) && grid.at(cell) == cost::kLethal) taken_.push_back(cell);
        }
      }
    }
  }
  const auto before = [](const Cell& a, const Cell& b) { return a.j != b.j ? a.j < b.j : a.i < b.i; };
  const auto same = [](const Cell& a, const Cell& b) { return a.i == b.i && a.j == b.j; };
  std::sort(taken_.begin(), taken_.end(), before);
  taken_.erase(std::unique(taken_.begin(), taken_.end(), same), taken_.end());
}

ExplainedCells::Window ExplainedCells::window_around(const GridView& grid, int reach) const {
  Window window{grid.size_x, 0, grid.size_y, 0};
  for (const Cell& cell : taken_) {
    window.i0 = std::min(window.i0, cell.i);
    window.i1 = std::max(window.i1, cell.i + 1);
    window.j0 = std::min(window.j0, cell.j);
    window.j1 = std::max(window.j1, cell.j + 1);
  }
  // Twice: whose cost may be theirs, and the lethal cells that these may belong to instead.
  return {std::max(0, window.i0 - 2 * reach), std::min(grid.size_x, window.i1 + 2 * reach),
          std::max(0, window.j0 - 2 * reach), std::min(grid.size_y, window.j1 + 2 * reach)};
}

// Squared distances in cells to the nearest lethal cell of the window, up to `reach`; farther ones are larger. Along
// the rows first, then over the columns.
void ExplainedCells::measure(const GridView& grid, const Window& window, int reach, std::vector<int>& squares) {
  rows_.assign(window.size(), kNone);
  squares.assign(window.size(), kNone * kNone);
  for (int j = window.j0; j < window.j1; ++j) {
    int last = -1;
    for (int i = window.i0; i < window.i1; ++i) {
      if (is_lethal(grid, i, j)) last = i;
      if (last >= 0 && i - last <= reach) rows_[window.index(i, j)] = i - last;
    }
    int next = -1;
    for (int i = window.i1 - 1; i >= window.i0; --i) {
      if (is_lethal(grid, i, j)) next = i;
      int& nearest = rows_[window.index(i, j)];
      if (next >= 0 && next - i <= reach) nearest = std::min(nearest, next - i);
    }
  }
  for (int j = window.j0; j < window.j1; ++j) {
    const int first = std::max(window.j0, j - reach), last = std::min(window.j1 - 1, j + reach);
    int* own = squares.data() + window.index(window.i0, j);
    for (int other = first; other <= last; ++other) {
      const int* along = rows_.data() + window.index(window.i0, other);
      const int across = (other - j) * (other - j);
      for (int k = 0; k < window.width(); ++k) {
        own[k] = std::min(own[k], across + along[k] * along[k]);
      }
    }
  }
}

// The largest cost that a cell at each distance has: that of inflation, or above.
void ExplainedCells::learn_costs(const GridView& grid, const Window& window, int reach) {
  cost_at_.assign(static_cast<std::size_t>(reach) * static_cast<std::size_t>(reach) + 1, cost::kFree);
  for (int j = window.j0; j < window.j1; ++j) {
    for (int i = window.i0; i < window.i1; ++i) {
      const int square = before_[window.index(i, j)];
      const std::uint8_t value = grid.at({i, j});
      if (square > reach * reach || value >= cost::kLethal) continue;
      std::uint8_t& known = cost_at_[static_cast<std::size_t>(square)];
      known = std::max(known, value);
    }
  }
}

void ExplainedCells::mend(const GridView& grid, const Window& window) {
  for (int j = window.j0; j < window.j1; ++j) {
    for (int i = window.i0; i < window.i1; ++i) {
      const std::size_t k = window.index(i, j);
      if (before_[k] == after_[k] || grid.at({i, j}) == cost::kUnknown) continue;
      const bool near = static_cast<std::size_t>(after_[k]) < cost_at_.size();
      const std::uint8_t value = near ? cost_at_[static_cast<std::size_t>(after_[k])] : cost::kFree;
      std::uint8_t& mended = costs_[grid.index({i, j})];
      mended = std::min(mended, value);
    }
  }
}

}  // namespace hidwa_local_planner
