// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/tile_surroundings.hpp"

#include <algorithm>

#include "core/distance/cell_index.hpp"
#include "core/distance/end_distances.hpp"

namespace hidwa_local_planner {
namespace {

// Clearances end here, in cells: the checker looks so far in any cycle.
constexpr double kMostClearance = 2.0;

}  // namespace

const DistanceGrid& TileSurroundings::grid_of(const PlanDistance& distance) {
  if (distance.to == PlanDistance::To::path) return cycle_.grids->to_path();
  if (distance.ahead == 0.0) return cycle_.grids->to_goal();
  return cycle_.grids->to_goal_ahead(distance.ahead, cycle_.pose, cycle_.goal);
}

bool TileSurroundings::distances(const Tile& tile, const PlanDistance& distance, double forward,
                                 const TileScores& scores, double* found) {
  if (!plan_on_map()) {
    std::fill_n(found, tile.count, -1.0);
    return false;
  }
  const bool centre_counts = cycle_.grids->measures() == MapGridDistance::geodesic;
  return EndDistances{*cycle_.grid, grid_of(distance), centre_counts, forward, scores}.find(tile, found);
}

void TileSurroundings::costs(const Tile& tile, std::size_t step, double* found) {
  const std::size_t row = step * tile.stride;
  for (std::size_t first = 0; first < tile.count; first += kernel::kMostPoints) {
    const std::size_t count = std::min(kernel::kMostPoints, tile.count - first);
    look_up_costs(tile.x + row + first, tile.y + row + first, count, found + first);
  }
}

// Of at most kMostPoints points.
void TileSurroundings::look_up_costs(const double* x, const double* y, std::size_t count, double* found) const {
  const GridView& grid = *cycle_.grid;
  std::int32_t i[kernel::kMostPoints], j[kernel::kMostPoints];
  kernel::find_cells(grid, {0, 0, grid.size_x, grid.size_y}, x, y, 0.0, 0.0, count, i, j);
  for (std::size_t c = 0; c < count; ++c) found[c] = i[c] >= 0 ? static_cast<double>(grid.at({i[c], j[c]})) : 0.0;
}

void TileSurroundings::clearances(const Tile& tile, std::size_t step, double* found) {
  const Rotation heading{tile.cos_heading[step], tile.sin_heading[step]};
  const double most = kMostClearance * cycle_.grid->resolution;
  for (std::size_t c = 0; c < tile.count; ++c) {
    found[c] = cycle_.checker->clearance(tile.pose(step, c), heading, most);
  }
}

}  // namespace hidwa_local_planner
