// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "sim/occupancy_map.hpp"
#include "sim/regions.hpp"

namespace hidwa_local_planner {
namespace sim {

/// For each cell the exact distance of its centre to the centre of the nearest marked cell.
class DistanceField {
 public:
  /// Distance to the occupied cells of `map`.
  static DistanceField to_obstacles(const OccupancyMap& map);

  /// Distance to the cells of `map` whose centre lies in a region.
  static DistanceField to_regions(const OccupancyMap& map, const std::vector<Region>& regions);

  /// Distance at the cell that holds (x, y) [m]; outside the map that of the nearest cell of its border.
  /// Without any marked cell it is larger than the map.
  double at(double x, double y) const;
  double at_cell(int column, int row) const { return distance_[map_.index(column, row)]; }

 private:
  DistanceField(const OccupancyMap& map, const std::vector<std::uint8_t>& marked);

  GridGeometry map_;
  std::vector<float> distance_;  // [m]
};

}  // namespace sim
}  // namespace hidwa_local_planner
