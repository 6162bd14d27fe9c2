// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/collision/collision.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/tile.hpp"

namespace hidwa_local_planner {

/// The classes of all cells that a cycle's candidates can reach, in a table small enough for the first cache, and of
/// the candidates' poses: one look-up a pose answers collision and every critic that asks for the centre's cell.
class CellClasses {
 public:
  /// Once per evaluation, after the checker; `reach` [m] as there.
  void prepare(const CollisionChecker& checker, const GridView& grid, bool unknown_is_obstacle, const Pose2& centre,
               double reach);
  /// Of a tile that has its poses. Valid until the next call.
  TileCells under(const Tile& tile);

  /// A square table of the map's cells around the robot.
  struct Table {
    double corner_x = 0.0, corner_y = 0.0;  // costmap frame [m]
    double cells_per_metre = 20.0;
    int width = 0, shift = 0;         // rows of `width` cells lie 2^shift apart
    std::vector<std::uint8_t> cells;  // classes

    std::size_t size() const { return std::size_t{1} << (2 * shift); }
    std::uint8_t* row(int j) { return cells.data() + (static_cast<std::size_t>(j) << shift); }
  };

 private:
  Table table_;
  std::vector<std::uint8_t> classes_;  // of the tile's poses
  std::vector<std::uint8_t> touched_;  // of the tile's candidates
  std::vector<std::int32_t> index_;    // of the tile's poses
};

}  // namespace hidwa_local_planner
