// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "drive/rolling_grid.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "sim/laser.hpp"
#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace drive {

/// One scan in the costmap's frame.
struct Beams {
  Point origin;             // of the sensor [m]
  std::vector<Point> ends;  // of the beams that say something [m]
};

/// Brings a scan of a sensor at `sensor` (costmap frame) into that frame. A beam that meets nothing ends just
/// inside range_max, so that it clears its whole length (`inf_is_valid`); what is too near or no number says
/// nothing.
void project(const std::vector<float>& ranges, const sim::LaserSpec& laser, const sim::Pose& sensor, Beams& beams);

/// Frees the cells on each beam, its end included, at most `range` [m] from the sensor; beyond the grid there
/// is nothing to free. A sensor outside the grid frees nothing.
void clear_along(const Beams& beams, double range, RollingGrid& grid);

/// Makes lethal the cell of each beam end nearer than `range` [m].
void mark_ends(const Beams& beams, double range, RollingGrid& grid);

/// Frees the cells of a convex polygon (costmap frame): those on its outline and between them. A polygon that
/// is not wholly in the grid frees nothing.
void clear_polygon(const Polygon& polygon, RollingGrid& grid);

}  // namespace drive
}  // namespace hidwa_local_planner
