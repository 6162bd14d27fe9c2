// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/tile_surroundings.hpp"

#include <algorithm>

#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

// Clearances end here, in cells: the checker looks so far in any cycle.
constexpr double kMostClearance = 2.0;

// The cells of the points (x[c] + dx, y[c] + dy); i is negative for those off the map.
HIDWA_VECTOR_CLONES
void cells_of_points(const GridView& grid, const double* __restrict x, const double* __restrict y, double dx, double dy,
                     std::size_t count, std::int32_t* __restrict i, std::int32_t* __restrict j) {
  const double scale = 1.0 / grid.resolution, corner_x = grid.origin_x, corner_y = grid.origin_y;
  const std::int32_t width = grid.size_x, height = grid.size_y;
  // One cell up before truncating, so that what lies just below the corner is not taken for the first cell.
  for (std::size_t c = 0; c < count; ++c) {
    const auto at_i = static_cast<std::int32_t>((x[c] + dx - corner_x) * scale + 1.0) - 1;
    const auto at_j = static_cast<std::int32_t>((y[c] + dy - corner_y) * scale + 1.0) - 1;
    const bool inside = (at_i >= 0) & (at_i < width) & (at_j >= 0) & (at_j < height);
    i[c] = inside ? at_i : -1;
    j[c] = at_j;
  }
}

}  // namespace

DistanceGrid TileSurroundings::grid_of(const PlanDistance& distance) {
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
  const DistanceGrid known = grid_of(distance);
  const GridView grid = *cycle_.grid;
  const bool centre_counts = cycle_.grids->measures() == MapGridDistance::geodesic;
  find_cells(tile, tile.steps, forward * tile.cos_heading[tile.steps], forward * tile.sin_heading[tile.steps]);
  known.free_metres(i_.data(), j_.data(), tile.count, found);
  bool all = true;
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (found[c] < 0.0 && centre_counts && !scores.rejected(c)) {
      const Pose2 last = tile.last_pose(c);
      found[c] = PlanGrids::at(known, grid, last.x, last.y);
    }
    all = all && found[c] >= 0.0;
  }
  return all;
}

// Of the points (dx, dy) [m] from the robot's centre in a step.
void TileSurroundings::find_cells(const Tile& tile, std::size_t step, double dx, double dy) {
  if (i_.size() < tile.count) {
    i_.resize(tile.count);
    j_.resize(tile.count);
  }
  const std::size_t row = step * tile.stride;
  cells_of_points(*cycle_.grid, tile.x + row, tile.y + row, dx, dy, tile.count, i_.data(), j_.data());
}

void TileSurroundings::costs(const Tile& tile, std::size_t step, double* found) {
  find_cells(tile, step, 0.0, 0.0);
  for (std::size_t c = 0; c < tile.count; ++c) {
    found[c] = i_[c] >= 0 ? static_cast<double>(cycle_.grid->at({i_[c], j_[c]})) : 0.0;
  }
}

void TileSurroundings::clearances(const Tile& tile, std::size_t step, double* found) {
  const Rotation heading{tile.cos_heading[step], tile.sin_heading[step]};
  const double most = kMostClearance * cycle_.grid->resolution;
  for (std::size_t c = 0; c < tile.count; ++c) {
    found[c] = cycle_.checker->clearance(tile.pose(step, c), heading, most);
  }
}

}  // namespace hidwa_local_planner
