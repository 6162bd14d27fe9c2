// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/collision/collision.hpp"
#include "hidwa_local_planner/core/tile.hpp"

namespace hidwa_local_planner {

/// The classes of the cells under the poses of a tile: one look-up a pose answers collision and every critic that asks
/// for the centre's cell.
class CellClasses {
 public:
  /// Of a tile that has its poses; `checker` is prepared, and reaches them. Valid until the next call.
  TileCells under(const CollisionChecker& checker, const Tile& tile);

 private:
  std::vector<std::uint8_t> classes_;  // of the tile's poses
  std::vector<std::uint8_t> touched_;  // of the tile's candidates
  std::vector<std::int32_t> index_;    // of the tile's poses
};

}  // namespace hidwa_local_planner
