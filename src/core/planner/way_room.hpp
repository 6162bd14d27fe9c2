// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/collision/collision.hpp"
#include "core/search/way.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// How narrow a way is on the map of now, and how fast a robot may follow it: the narrower the slower, so that it keeps
/// to the middle, and can still brake where laser noise takes the rest of the room away. Before narrow places it slows
/// down in good time.
struct WayRoom {
  double least = 0.0;    // clearance of the poses ahead, a cell at most [m]
  double fastest = 0.0;  // that the robot may drive now [m/s]

  /// The part of `way` that follows station `part` and takes three seconds. `here` [m]: the clearance of the robot
  /// itself. `creeping`, `full` [m/s]: speeds without any clearance, and from a cell on.
  static WayRoom look(const Way& way, std::size_t part, const CollisionChecker& collision, double cell, double here,
                      double creeping, double full);
};

}  // namespace hidwa_local_planner
