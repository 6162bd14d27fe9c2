// SPDX-License-Identifier: BSD-3-Clause
#include "drive/seen_map.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace hidwa_local_planner {
namespace drive {

// A grid's corner lies at its frame's origin: beams are brought there.
SeenMap::SeenMap(const sim::GridGeometry& geometry, double range)
    : geometry_(geometry),
      range_(range),
      grid_(std::max(geometry.width, geometry.height) * geometry.resolution, geometry.resolution) {}

void SeenMap::add(const Beams& beams) {
  const Point corner(geometry_.origin_x, geometry_.origin_y);
  Beams moved{beams.origin - corner, beams.ends};
  for (Point& end : moved.ends) end -= corner;
  clear_along(moved, range_, grid_);
  mark_ends(moved, range_, grid_);
}

sim::OccupancyMap SeenMap::map() const {
  sim::OccupancyMap map =
      sim::make_map(geometry_.width, geometry_.height, geometry_.resolution, geometry_.origin_x, geometry_.origin_y);
  for (int row = 0; row < map.height; ++row) {
    const std::uint8_t* costs = grid_.row(row);
    for (int column = 0; column < map.width; ++column) {
      if (costs[column] == cost::kLethal) map.cells[map.index(column, row)] = sim::Cell::kOccupied;
    }
  }
  return map;
}

}  // namespace drive
}  // namespace hidwa_local_planner
