// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "core/collision/cell_classes.hpp"
#include "core/distance/cell_index.hpp"
#include "core/distance/end_cells.hpp"
#include "core/distance/plan_grids.hpp"
#include "critics/built_in_entry.hpp"
#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner::critics {
namespace {

/// The cost of the cell under the robot's centre at the last pose, or summed over all poses, in [0, 252] a pose.
/// Refuses candidates whose centre enters lethal, inscribed or (by policy) unknown cells or leaves the map; not where
/// the robot already stands in one and `escape` is on, or it could never leave.
class BaseObstacle : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;
  void prepare(const CycleView& cycle) override;
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override;

 private:
  bool obstacle(const GridView& grid, double x, double y) const;
  void add_costs(const GridView& grid, const Tile& tile, std::size_t k, std::size_t first, std::size_t count,
                 double* sum) const;
  void add_last_costs(const CycleView& cycle, const Tile& tile, std::size_t first, std::size_t count,
                      double* sum) const;
  bool hits(const GridView& grid, const Tile& tile, std::size_t c) const;

  bool sum_scores_ = false;
  bool escape_ = true;
  bool unknown_is_obstacle_ = true;
  bool refuses_ = true;
};

double BaseObstacle::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  sum_scores_ = parameters.BaseObstacle_sum_scores;
  escape_ = parameters.escape;
  unknown_is_obstacle_ = parameters.unknown_is_obstacle;
  return parameters.BaseObstacle_scale;
}

bool BaseObstacle::obstacle(const GridView& grid, double x, double y) const {
  const Cell cell = grid.cell_at(x, y);
  if (!grid.contains(cell)) return true;
  const std::uint8_t value = grid.at(cell);
  return value == cost::kLethal || value == cost::kInscribed || (value == cost::kUnknown && unknown_is_obstacle_);
}

void BaseObstacle::prepare(const CycleView& cycle) {
  refuses_ = !(escape_ && obstacle(*cycle.grid, cycle.pose.x, cycle.pose.y));
}

void BaseObstacle::score(const CycleView& cycle, const Tile& tile, TileScores& scores) {
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
void BaseObstacle::add_costs(const GridView& grid, const Tile& tile, std::size_t k, std::size_t first,
                             std::size_t count, double* sum) const {
  std::int32_t i[kernel::kMostPoints], j[kernel::kMostPoints];
  const std::size_t row = k * tile.stride + first;
  kernel::find_cells(grid, {0, 0, grid.size_x, grid.size_y}, tile.x + row, tile.y + row, 0.0, 0.0, count, i, j);
  for (std::size_t c = 0; c < count; ++c) {
    if (i[c] >= 0) sum[c] += static_cast<double>(grid.at({i[c], j[c]}));
  }
}

// Likewise in the last step, where other critics look too.
void BaseObstacle::add_last_costs(const CycleView& cycle, const Tile& tile, std::size_t first, std::size_t count,
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

bool BaseObstacle::hits(const GridView& grid, const Tile& tile, std::size_t c) const {
  if (tile.touched != nullptr) return (tile.touched[c] & cell_class::kBlocked) != 0;
  for (std::size_t k = 0; k <= tile.steps; ++k) {
    if (obstacle(grid, tile.x_at(k, c), tile.y_at(k, c))) return true;
  }
  return false;
}

const BuiltInEntry entry("BaseObstacle", make<BaseObstacle>);

}  // namespace
}  // namespace hidwa_local_planner::critics
