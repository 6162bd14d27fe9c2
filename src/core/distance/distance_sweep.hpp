// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"

namespace hidwa_local_planner {

/// Shortest ways through a grid from up to four sets of cells at once. Rows are swept down and up until nothing
/// changes: a row takes from the row before it, a loop that vectorises, then from its own cells. Two sweeps do for open
/// space, one or two more for every turn of a maze. Keeps its memory.
class DistanceSweep {
 public:
  static constexpr int kLanes = 4;
  /// A cell that nothing reaches. Ways of more than this many units count as none.
  static constexpr std::int16_t kFar = 0x3F3F;  // a step and a mask more still fit; of equal bytes, for memset

  /// Units of a step along an axis and of one across.
  struct Steps {
    std::int16_t straight = 5;
    std::int16_t diagonal = 7;
  };

  /// A grid of free cells that nothing reaches.
  void reset(int width, int height, const Steps& steps);
  /// Nothing passes through a blocked cell nor into it; `costs` is one row.
  void block_lethal_and_inscribed(int row, const std::uint8_t* costs);
  /// A cell where the ways of a lane begin, blocked or not.
  void seed(int lane, Cell cell);
  /// Finds all ways through free cells.
  void settle();
  /// Then the ways into blocked cells, from the free ones beside them on inwards; free cells keep theirs.
  void settle_blocked();

  std::int16_t units(int lane, Cell cell) const { return units_[at(cell) + static_cast<std::size_t>(lane)]; }
  bool blocked(Cell cell) const { return mask_[at(cell)] != open_; }
  /// Blocked cells count as those that nothing reaches.
  std::int16_t free_units(int lane, Cell cell) const { return blocked(cell) ? kFar : units(lane, cell); }

 private:
  // A border of one cell all around needs no bounds test.
  std::size_t at(Cell cell) const {
    return kLanes * (static_cast<std::size_t>(cell.j + 1) * stride_ + static_cast<std::size_t>(cell.i + 1));
  }
  bool sweep(bool down);
  bool update(int row, int from, bool anyhow);

  int width_ = 0, height_ = 0;
  std::size_t stride_ = 0;  // [cells]
  Steps steps_;
  std::int16_t open_ = 0;            // the mask of a free cell: changes when the blocked ones are settled
  std::vector<std::int16_t> units_;  // [cells][lanes]
  std::vector<std::int16_t> mask_;   // [cells][lanes] kFar where a cell takes nothing: what it costs more to enter
  std::vector<std::int16_t> taken_, rightward_, leftward_;  // one row each
  std::vector<std::uint8_t> due_down_, due_up_;             // rows whose neighbour changed
};

}  // namespace hidwa_local_planner
