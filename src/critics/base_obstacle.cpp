// SPDX-License-Identifier: BSD-3-Clause
#include "critics/base_obstacle.hpp"

#include <algorithm>

#include "core/collision/cell_classes.hpp"
#include "core/distance/cell_index.hpp"
#include "core/distance/end_cells.hpp"
#include "core/distance/plan_grids.hpp"

namespace hidwa_local_planner {

double BaseObstacleCritic::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  sum_scores_ = parameters.BaseObstacle_sum_scores;
  escape_ = parameters.escape;
  unknown_is_obstacle_ = parameters.unknown_is_obstacle;
  return parameters.BaseObstacle_scale;
}

bool BaseObstacleCritic::obstacle(const GridView& grid, double x, double y) const {
  const Cell cell = grid.cell_at(x, y);
  if (!grid.contains(cell)) return true;
  const std::uint8_t value = grid.at(cell);
  return value == cost::kLethal || value == cost::kInscribed || (value == cost::kUnknown && unknown_is_obstacle_);
}

void BaseObstacleCritic::prepare(const CycleView& cycle) {
  refuses_ = !(escape_ && obstacle(*cycle.grid, cycle.pose.x, cycle.pose.y));
}

void BaseObstacleCritic::score(const CycleView& cycle, const Tile& tile, TileScores& scores) {
  double* raw = scores.set_all();
  std::fill_n(raw, tile.count, 0.0);
  for (std::size_t first = 0; first < tile.count; first += kernel::kMostPoints) {
    const std::size_t count = std::min(kernel::kMostPoints, tile.count - first);
    for (std::size_t k = 0; sum_scores_ && k <= tile.steps; ++k)
      add_costs(*cycle.grid, tile, k, first, count, raw + first);
    if (!sum_scores_) add_last_costs(cycle, tile, first, count, raw + first);
  }
  if (!refuses_ || (tile.touched_any & cell_class::kBlocked) == 0) return;
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (!scores.refused(c) && hits(*cycle.grid, tile, c))
      scores.refuse(c, "centre hits an obstacle or its inscribed cells");
  }
}

// Of the centres' cells in one step.
void BaseObstacleCritic::add_costs(const GridView& grid, const Tile& tile, std::size_t k, std::size_t first,
                                   std::size_t count, double* sum) const {
  std::int32_t i[kernel::kMostPoints], j[kernel::kMostPoints];
  const std::size_t row = k * tile.stride + first;
  kernel::find_cells(grid, {0, 0, grid.size_x, grid.size_y}, tile.x + row, tile.y + row, 0.0, 0.0, count, i, j);
  for (std::size_t c = 0; c < count; ++c) {
    if (i[c] >= 0) sum[c] += static_cast<double>(grid.at({i[c], j[c]}));
  }
}

// Likewise in the last step, where other critics look too.
void BaseObstacleCritic::add_last_costs(const CycleView& cycle, const Tile& tile, std::size_t first, std::size_t count,
                                        double* sum) const {
  if (tile.ends == nullptr || cycle.grids == nullptr)
    return add_costs(*cycle.grid, tile, tile.steps, first, count, sum);
  const kernel::CellBox& box = cycle.grids->interest();
  const EndCells::Cells ends = tile.ends->of(*cycle.grid, box, tile, 0.0);
  for (std::size_t c = 0; c < count; ++c) {
    if (ends.i[first + c] >= 0) {
      sum[c] = static_cast<double>(cycle.grid->at({box.i + ends.i[first + c], box.j + ends.j[first + c]}));
    } else {
      add_costs(*cycle.grid, tile, tile.steps, first + c, 1, sum + c);
    }
  }
}

bool BaseObstacleCritic::hits(const GridView& grid, const Tile& tile, std::size_t c) const {
  if (tile.touched != nullptr) return (tile.touched[c] & cell_class::kBlocked) != 0;
  for (std::size_t k = 0; k <= tile.steps; ++k) {
    if (obstacle(grid, tile.x_at(k, c), tile.y_at(k, c))) return true;
  }
  return false;
}

}  // namespace hidwa_local_planner
