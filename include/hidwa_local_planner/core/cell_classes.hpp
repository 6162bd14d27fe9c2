// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/collision.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/trajectory_batch.hpp"

namespace hidwa_local_planner {

/// What a cell means to a robot whose centre is in it.
namespace cell_class {
constexpr std::uint8_t kNear = 1;     // it may overlap an obstacle: its outline decides
constexpr std::uint8_t kHit = 2;      // it overlaps one at any heading
constexpr std::uint8_t kBlocked = 4;  // lethal, inscribed, unknown where that is an obstacle, or off the map
}  // namespace cell_class

/// The classes of all cells that a cycle's candidates can reach, in a table small enough for the first cache, and of the
/// candidates' poses: one look-up a pose answers collision and every critic that asks for the centre's cell.
class CellClasses {
 public:
  /// Once a cycle, after the checker; `reach` [m] as there.
  void prepare(const CollisionChecker& checker, const GridView& grid, bool unknown_is_obstacle, const Pose2& centre,
               double reach);
  /// Sets `classes` and `touched` of a tile. Valid until the next call.
  void classify(Tile& tile);

 private:
  // Where the poses of one row of a tile lie, at most [m].
  struct Box {
    double lo_x, lo_y, hi_x, hi_y;
  };
  void fill_row(const CollisionChecker& checker, const GridView& grid, int row);
  void count_marked();
  bool unmarked(const Box& box) const;
  void find_open_rows(const Tile& tile);
  void classify_rows(const Tile& tile, std::size_t first, std::size_t end);

  Cell first_;               // of the table, map cells
  double corner_x_ = 0.0, corner_y_ = 0.0;  // of the table [m]
  double cells_per_metre_ = 20.0;
  int width_ = 0, shift_ = 0;          // the table's rows are 2^shift cells long
  std::uint32_t wrap_ = 0;             // index mask
  std::uint8_t blocked_by_cost_[256] = {};
  std::vector<std::uint8_t> table_;
  std::vector<std::uint32_t> marked_;  // [(width + 1)^2] cells of any class below and to the left of a corner
  std::vector<std::uint8_t> classes_;  // of the tile's poses
  std::vector<std::uint8_t> touched_;  // of the tile's candidates
  std::vector<std::int32_t> index_;    // of the tile's poses
  std::vector<Box> boxes_;             // of the tile's rows
  std::vector<std::uint8_t> open_;     // of the tile's rows: no cell within reach of it has a class
};

}  // namespace hidwa_local_planner
