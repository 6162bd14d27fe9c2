// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "sim/occupancy_map.hpp"

namespace hidwa_local_planner {
namespace sim {

/// Casts rays through a map. Each cell knows the largest square round it that is free, which a ray leaps in
/// one go; within the last cells it goes cell by cell, so ranges are exact.
class RayCaster {
 public:
  explicit RayCaster(const OccupancyMap& map);

  /// Distance from (x, y) in direction `angle` to where the ray enters the first occupied cell [m]; infinite
  /// if none within `range_max`. 0 inside an occupied cell. Nothing outside the map is occupied.
  double range(double x, double y, double angle, double range_max) const;

 private:
  int free_reach(int column, int row) const;

  OccupancyMap map_;                 // its geometry alone; no cells
  std::vector<std::uint8_t> reach_;  // [cells], every cell nearer than this is free; 0: occupied
};

}  // namespace sim
}  // namespace hidwa_local_planner
