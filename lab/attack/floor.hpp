// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/occupancy_map.hpp"
#include "world.hpp"

namespace hidwa_attack {

/// A map's cells from its lower left corner on: what is not known to be free is lethal.
inline World world_of(const hidwa_local_planner::sim::OccupancyMap& map) {
  using hidwa_local_planner::sim::Cell;
  World world(map.width * map.resolution, map.height * map.resolution, map.resolution);
  for (int j = 0; j < map.height; ++j) {
    for (int i = 0; i < map.width; ++i) world.set(i, j, map.cells[map.index(i, j)] != Cell::kFree);
  }
  return world;
}

}  // namespace hidwa_attack
