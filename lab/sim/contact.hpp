// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/occupancy_map.hpp"
#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace sim {

/// Whether the polygon (map frame) overlaps an occupied cell. The judge of every drive: it shares no code
/// with the planner's own check, and asks each cell under the polygon's bounding box.
bool overlaps_occupied(const OccupancyMap& map, const Polygon& polygon);

/// Whether the polygon overlaps the square cell with lower left corner (x, y) and side `size` [m].
bool overlaps_cell(const Polygon& polygon, double x, double y, double size);

}  // namespace sim
}  // namespace hidwa_local_planner
