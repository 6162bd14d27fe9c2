// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/critics/base_obstacle.hpp"

#include <algorithm>

#include "hidwa_local_planner/core/cell_classes.hpp"
#include "hidwa_local_planner/core/cell_index.hpp"

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
  for (std::size_t first = 0; first < tile.count; first += kernel::kMostPoints) {
    score_some(cycle, tile, first, std::min(kernel::kMostPoints, tile.count - first), scores);
  }
}

void BaseObstacleCritic::score_some(const CycleView& cycle, const Tile& tile, std::size_t first, std::size_t count,
                                    TileScores& scores) const {
  double sum[kernel::kMostPoints] = {};
  std::int32_t i[kernel::kMostPoints], j[kernel::kMostPoints];
  const GridView& grid = *cycle.grid;
  for (std::size_t k = sum_scores_ ? 0 : tile.steps; k <= tile.steps; ++k) {
    const std::size_t row = k * tile.stride + first;
    kernel::find_cells(grid, {0, 0, grid.size_x, grid.size_y}, tile.x + row, tile.y + row, 0.0, 0.0, count, i, j);
    for (std::size_t c = 0; c < count; ++c) {
      if (i[c] >= 0) sum[c] += static_cast<double>(grid.at({i[c], j[c]}));
    }
  }
  for (std::size_t c = first; c < first + count; ++c) {
    if (scores.refused(c)) continue;
    if (refuses_ && hits(grid, tile, c)) {
      scores.refuse(c, "centre hits an obstacle or its inscribed cells");
    } else {
      scores.set(c, sum[c - first]);
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
