// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/beams.hpp"
#include "drive/rolling_grid.hpp"
#include "sim/occupancy_map.hpp"

namespace hidwa_local_planner {
namespace drive {

/// What a laser has seen so far, in the map's frame: the obstacle layer of a global costmap that has no map.
/// Beams clear, then mark; what was never seen is free. Localisation is taken to be perfect.
class SeenMap {
 public:
  /// A grid of this map's geometry; its cells do not count. Beam ends farther away than `range` [m] are not
  /// marked.
  SeenMap(const sim::GridGeometry& geometry, double range);

  /// One scan, map frame.
  void add(const Beams& beams);

  /// Everything seen so far.
  sim::OccupancyMap map() const;

 private:
  sim::GridGeometry geometry_;
  double range_;      // [m]
  RollingGrid grid_;  // its first cell is the map's
};

}  // namespace drive
}  // namespace hidwa_local_planner
