// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::control {

/// Whether the robot's centre would collide between two points in the costmap's frame; off the map it does not. The
/// line is looked at in steps of half a cell at most, its start not. One that is longer than a million steps, or leads
/// from or to no place, crosses nothing.
inline bool crosses_obstacle(const Point& from, const Point& to, const GridView& grid) {
  const Point along = to - from;
  const double parts = std::ceil(along.norm() / (0.5 * grid.resolution));
  if (!(parts <= 1e6)) return false;
  const int steps = std::max(1, static_cast<int>(parts));
  for (int s = 1; s <= steps; ++s) {
    const Point at = from + along * (static_cast<double>(s) / steps);
    if (grid.holds(at) && cost::blocks(grid.at(grid.cell_at(at.x(), at.y())))) return true;
  }
  return false;
}

}  // namespace hidwa_local_planner::control
