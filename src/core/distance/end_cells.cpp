// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/end_cells.hpp"

#include <algorithm>

namespace hidwa_local_planner {

EndCells::Cells EndCells::of(const GridView& grid, const kernel::CellBox& box, const Tile& tile, double forward) {
  for (std::size_t k = 0; k < known_; ++k) {
    if (sets_[k].forward == forward && sets_[k].box == box) return {sets_[k].i.data(), sets_[k].j.data()};
  }
  known_ = std::min(known_ + 1, sets_.size());  // the last one makes way
  Set& set = sets_[known_ - 1];
  set.forward = forward;
  set.box = box;
  if (set.i.size() < tile.count) {
    set.i.resize(tile.stride);
    set.j.resize(tile.stride);
  }
  const std::size_t row = tile.steps * tile.stride;
  kernel::find_cells(grid, box, tile.x + row, tile.y + row, forward * tile.cos_heading[tile.steps],
                     forward * tile.sin_heading[tile.steps], tile.count, set.i.data(), set.j.data());
  return {set.i.data(), set.j.data()};
}

}  // namespace hidwa_local_planner
