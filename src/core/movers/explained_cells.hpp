// SPDX-License-Identifier: BSD-3-Clause
// A mover counts once: by its disc from now on, and not by the cells of the costmap that its points explain.
//
// 1. A lethal cell is explained that holds a point of a mover, or is a neighbour (of 8) of one that does: points and
//    costmap were measured at different times, and a point may lie on a cell's edge. A cell that the mover's disc does
//    not cover as a whole is not explained: there the cell alone keeps the robot out.
// 2. In a copy of the costmap explained cells are no obstacles any more.
// 3. Costs around them were theirs where no other lethal cell is as near. Such a cell gets the cost that belongs to the
//    distance from the lethal cells that remain. Which cost belongs to which distance the map itself says: around its
//    lethal cells, before any was taken out, it holds both. What was not seen there is free.
//
// Unknown cells stay as they are. Nothing here knows the static map: who sends points says that nothing else stands
// there. The copy is made only where there is something to take out.
#pragma once

#include <cstdint>
#include <vector>

#include "core/movers/lethal_distances.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner {

class ExplainedCells {
 public:
  /// How far around a lethal cell costs are taken to be its own, at most [m]; on fine maps LethalDistances::kMost
  /// cells.
  static constexpr double kFarthestCost = 1.0;

  /// The costmap without what the movers' points explain; `grid` itself where that is nothing. Valid until the next
  /// call.
  GridView without(const GridView& grid, const MovingObstacleEstimates& movers, const Parameters& parameters);

 private:
  void reserve(const GridView& grid);
  void find_explained(const GridView& grid, const MovingObstacleEstimates& movers, const Parameters& parameters);
  CellWindow window_around(const GridView& grid, int reach) const;
  void learn_costs(const GridView& grid, const CellWindow& window, int reach);
  void mend(const GridView& grid, const CellWindow& window);

  std::vector<std::uint8_t> costs_;
  std::vector<Cell> taken_;
  LethalDistances before_, after_;     // with and without the taken
  std::vector<std::uint8_t> cost_at_;  // by squared distance [cells^2]
};

}  // namespace hidwa_local_planner
