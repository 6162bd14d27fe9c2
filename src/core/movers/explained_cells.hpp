// SPDX-License-Identifier: BSD-3-Clause
// A mover counts once: by its disc from now on, and not by the cells of the costmap that its points explain.
//
// 1. A lethal cell is explained that holds a point of a mover, or is a neighbour (of 8) of one that does: points and
//    costmap were measured at different times, and a point may lie on a cell's edge. A point that the mover's disc does
//    not cover explains nothing.
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

#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/moving_obstacle.hpp"

namespace hidwa_local_planner {

class ExplainedCells {
 public:
  /// How far around a lethal cell costs are taken to be its own, at most [m].
  static constexpr double kFarthestCost = 1.0;

  /// The costmap without what the movers' points explain; `grid` itself where that is nothing. Valid until the next
  /// call.
  GridView without(const GridView& grid, const MovingObstacleEstimates& movers);
  /// So many cells were taken out.
  std::size_t count() const { return taken_.size(); }

 private:
  struct Window {
    int i0 = 0, i1 = 0, j0 = 0, j1 = 0;  // cells, ends not included
    int width() const { return i1 - i0; }
    std::size_t index(int i, int j) const {
      return static_cast<std::size_t>(j - j0) * static_cast<std::size_t>(width()) + static_cast<std::size_t>(i - i0);
    }
    std::size_t size() const { return static_cast<std::size_t>(width()) * static_cast<std::size_t>(j1 - j0); }
  };
  void reserve(const GridView& grid);
  void find_explained(const GridView& grid, const MovingObstacleEstimates& movers);
  Window window_around(const GridView& grid, int reach) const;
  void measure(const GridView& grid, const Window& window, int reach, std::vector<int>& squares);
  void learn_costs(const GridView& grid, const Window& window, int reach);
  void mend(const GridView& grid, const Window& window);

  std::vector<std::uint8_t> costs_;
  std::vector<Cell> taken_;
  std::vector<int> rows_;            // [window] to the nearest lethal cell of the same row [cells]
  std::vector<int> before_, after_;  // [window] squared distance to the nearest lethal cell, with and without the taken
  std::vector<std::uint8_t> cost_at_;  // by squared distance [cells^2]
};

}  // namespace hidwa_local_planner
