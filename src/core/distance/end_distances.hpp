// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/distance/distance_grid.hpp"
#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/tile.hpp"

namespace hidwa_local_planner {

/// How far the candidates of a tile end from the plan: many at a time as far as a table tells, the others one by one.
///
///  1. Find the cells of the points `forward` ahead of the last poses, the noses.
///  2. Look their distances up in the table. It tells those of free cells that are surely exact; mostly that is all.
///  3. Where a nose lies on a blocked cell, look the centre's up in the table.
///  4. What is left is asked one by one, of candidates that nobody has rejected: that may sweep the whole map.
///
/// Steps 2 and 3 tell what step 4 would: a distance in the table is the exact one, or it says that it is not.
struct EndDistances {
  const GridView& grid;
  const DistanceGrid& distances;
  bool centre_counts;        // where the nose has no distance, or lies on a blocked cell
  double forward;            // of the nose, ahead of the last pose [m]
  const TileScores& scores;  // candidates rejected in here are not asked about

  /// Distances [tile.count] [m], see Surroundings::distances().
  bool find(const Tile& tile, double* found) const;

 private:
  struct Cells;
  bool find_some(const Tile& tile, std::size_t first, double* found) const;
  void ask_centres(const Tile& tile, std::size_t first, const Cells& noses, double* found) const;
  double distance_of(const Tile& tile, std::size_t c) const;
};

}  // namespace hidwa_local_planner
