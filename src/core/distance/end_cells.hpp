// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/distance/cell_index.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/tile.hpp"

namespace hidwa_local_planner {

/// The cells in which the rollouts of a tile end: found when first asked for, then shared by all critics that ask
/// alike.
class EndCells {
 public:
  /// Counted from the lowest cell of a box; i is negative outside it.
  struct Cells {
    const std::int32_t* i = nullptr;  // [tile.count]
    const std::int32_t* j = nullptr;  // [tile.count]
  };

  /// Another tile comes next.
  void forget() { known_ = 0; }
  /// Of the points `forward` [m] ahead of the last poses, in a box of the grid. Valid until the next
  /// call.
  Cells of(const GridView& grid, const kernel::CellBox& box, const Tile& tile, double forward);

 private:
  struct Set {
    double forward = 0.0;
    kernel::CellBox box;
    std::vector<std::int32_t> i, j;
  };
  std::array<Set, 4> sets_;  // by what was asked for last
  std::size_t known_ = 0;    // sets
};

}  // namespace hidwa_local_planner
