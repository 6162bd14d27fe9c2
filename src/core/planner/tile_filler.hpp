// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/distance/end_cells.hpp"
#include "core/planner/candidates.hpp"
#include "core/planner/surroundings.hpp"

namespace hidwa_local_planner {

/// Makes tiles with all that checks and critics read of them.
class TileFiller {
 public:
  TileFiller(const Candidates& candidates, Surroundings& surroundings)
      : candidates_(candidates), surroundings_(surroundings) {}

  /// Valid until the next call.
  Tile tile(std::size_t index) {
    Tile tile = candidates_.rollout().tile(index);
    surroundings_.classify(tile);
    ends_.forget();
    tile.ends = &ends_;
    return tile;
  }

 private:
  const Candidates& candidates_;
  Surroundings& surroundings_;
  EndCells ends_;
};

}  // namespace hidwa_local_planner
