// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/end_distances.hpp"

#include <algorithm>

#include "core/distance/cell_index.hpp"
#include "core/distance/plan_grids.hpp"

namespace hidwa_local_planner {
namespace {

double distance_of(const EndDistances::Question& q, const Tile& tile, std::size_t c) {
  const Pose2 last = tile.last_pose(c);
  const double x = last.x + q.forward * tile.cos_heading[tile.steps];
  const double y = last.y + q.forward * tile.sin_heading[tile.steps];
  if (!q.centre_counts) return PlanGrids::at(q.distances, q.grid, x, y);
  const Cell nose = q.grid.cell_at(x, y);
  if (q.grid.contains(nose) && !cost::blocks(q.grid.at(nose))) {
    const double distance = PlanGrids::at(q.distances, q.grid, x, y);
    if (distance >= 0.0) return distance;
  }
  return PlanGrids::at(q.distances, q.grid, last.x, last.y);
}

}  // namespace

bool EndDistances::find(const Question& question, const Tile& tile, double* found) {
  bool all = true;
  for (std::size_t first = 0; first < tile.count; first += kernel::kMostPoints) {
    if (!find_some(question, tile, first, found + first)) all = false;
  }
  return all;
}

// At most kMostPoints candidates from `first` on.
bool EndDistances::find_some(const Question& question, const Tile& tile, std::size_t first, double* found) {
  const DistanceGrids::Table table = question.distances.table();
  const EndCells::Cells noses = cells_.of(question.grid, table.box, tile, question.forward);
  const std::size_t count = std::min(kernel::kMostPoints, tile.count - first);
  const double metres = question.distances.metres_per_unit();
  if (table.free_distances(noses.i + first, noses.j + first, count, metres, found)) return true;
  if (question.centre_counts) ask_centres(question, tile, first, count, found);
  bool all = true;
  for (std::size_t c = 0; c < count; ++c) {
    if (found[c] >= 0.0) continue;
    found[c] = question.scores.rejected(first + c) ? -1.0 : distance_of(question, tile, first + c);
    all = all && found[c] >= 0.0;
  }
  return all;
}

void EndDistances::ask_centres(const Question& question, const Tile& tile, std::size_t first, std::size_t count,
                               double* found) {
  const GridView& grid = question.grid;
  const DistanceGrids::Table table = question.distances.table();
  double of_centres[kernel::kMostPoints];
  const EndCells::Cells centres = cells_.of(grid, table.box, tile, 0.0);
  table.free_distances(centres.i + first, centres.j + first, count, question.distances.metres_per_unit(), of_centres);
  const EndCells::Cells noses = cells_.of(grid, table.box, tile, question.forward);
  for (std::size_t c = 0; c < count; ++c) {
    const Cell nose{noses.i[first + c], noses.j[first + c]};
    if (found[c] >= 0.0 || nose.i < 0) continue;
    if (cost::blocks(grid.at({table.box.i + nose.i, table.box.j + nose.j}))) found[c] = of_centres[c];
  }
}

}  // namespace hidwa_local_planner
