// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/critics/base_obstacle.hpp"

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
  const GridView& grid = *cycle.grid;
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (scores.refused(c)) continue;
    double sum = 0.0;
    double last = 0.0;
    bool hit = false;
    for (std::size_t k = 0; k <= tile.steps && !hit; ++k) {
      const double x = tile.x_at(k, c), y = tile.y_at(k, c);
      hit = refuses_ && obstacle(grid, x, y);
      const Cell cell = grid.cell_at(x, y);
      last = grid.contains(cell) ? static_cast<double>(grid.at(cell)) : 0.0;
      sum += last;
    }
    if (hit) {
      scores.refuse(c, "centre hits an obstacle or its inscribed cells");
    } else {
      scores.set(c, sum_scores_ ? sum : last);
    }
  }
}

}  // namespace hidwa_local_planner
