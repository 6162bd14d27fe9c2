// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/evaluation/candidates.hpp"
#include "core/evaluation/obstacles.hpp"
#include "core/evaluation/tile_surroundings.hpp"

namespace hidwa_local_planner {

/// Makes tiles with all that checks and critics read of them.
class TileFiller {
 public:
  TileFiller(const Candidates& candidates, Obstacles& obstacles) : candidates_(candidates), obstacles_(obstacles) {}

  /// Once per evaluation.
  void prepare(const TileSurroundings::Cycle& cycle) { surroundings_.prepare(cycle); }
  TileSurroundings& surroundings() { return surroundings_; }

  /// Valid until the next call.
  Tile tile(std::size_t index) {
    Tile tile = candidates_.rollout().tile(index);
    tile.cells = obstacles_.cells_under(tile);
    surroundings_.begin(tile);
    return tile;
  }

 private:
  const Candidates& candidates_;
  Obstacles& obstacles_;
  TileSurroundings surroundings_;
};

}  // namespace hidwa_local_planner
