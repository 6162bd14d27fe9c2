// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/end_distances.hpp"

#include <algorithm>
#include <cstdint>

#include "core/distance/cell_index.hpp"
#include "core/distance/plan_grids.hpp"

namespace hidwa_local_planner {

// Of the points `forward` [m] ahead of the last poses, at most kMostPoints from the candidate `first` on. Counted from
// the lowest cell of the box; i is negative outside it.
struct EndDistances::Cells {
  Cells(const GridView& grid, const kernel::CellBox& box, const Tile& tile, std::size_t first, double forward)
      : count(std::min(kernel::kMostPoints, tile.count - first)) {
    const std::size_t at = tile.steps * tile.stride + first;
    kernel::find_cells(grid, box, tile.x + at, tile.y + at, forward * tile.cos_heading[tile.steps],
                       forward * tile.sin_heading[tile.steps], count, i, j);
  }
  std::size_t count;
  std::int32_t i[kernel::kMostPoints], j[kernel::kMostPoints];
};

bool EndDistances::find(const Tile& tile, double* found) const {
  bool all = true;
  for (std::size_t first = 0; first < tile.count; first += kernel::kMostPoints) {
    if (!find_some(tile, first, found + first)) all = false;
  }
  return all;
}

// At most kMostPoints candidates from `first` on.
bool EndDistances::find_some(const Tile& tile, std::size_t first, double* found) const {
  const DistanceGrids::Table table = distances.table();
  const Cells noses(grid, table.box, tile, first, forward);
  if (table.free_distances(noses.i, noses.j, noses.count, distances.metres_per_unit(), found)) return true;
  if (centre_counts) ask_centres(tile, first, noses, found);
  bool all = true;
  for (std::size_t c = 0; c < noses.count; ++c) {
    if (found[c] >= 0.0) continue;
    found[c] = scores.rejected(first + c) ? -1.0 : distance_of(tile, first + c);
    all = all && found[c] >= 0.0;
  }
  return all;
}

void EndDistances::ask_centres(const Tile& tile, std::size_t first, const Cells& noses, double* found) const {
  const DistanceGrids::Table table = distances.table();
  double of_centres[kernel::kMostPoints];
  const Cells centres(grid, table.box, tile, first, 0.0);
  table.free_distances(centres.i, centres.j, centres.count, distances.metres_per_unit(), of_centres);
  for (std::size_t c = 0; c < noses.count; ++c) {
    if (found[c] >= 0.0 || noses.i[c] < 0) continue;
    if (cost::blocks(grid.at({table.box.i + noses.i[c], table.box.j + noses.j[c]}))) found[c] = of_centres[c];
  }
}

double EndDistances::distance_of(const Tile& tile, std::size_t c) const {
  const Pose2 last = tile.last_pose(c);
  const double x = last.x + forward * tile.cos_heading[tile.steps];
  const double y = last.y + forward * tile.sin_heading[tile.steps];
  if (!centre_counts) return PlanGrids::at(distances, grid, x, y);
  const Cell nose = grid.cell_at(x, y);
  if (grid.contains(nose) && !cost::blocks(grid.at(nose))) {
    const double distance = PlanGrids::at(distances, grid, x, y);
    if (distance >= 0.0) return distance;
  }
  return PlanGrids::at(distances, grid, last.x, last.y);
}

}  // namespace hidwa_local_planner
