// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "sim/mover.hpp"
#include "sim/occupancy_map.hpp"
#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace drive {

/// Where beams met people, for as long as the local costmap holds a mark of it: hidden by somebody, a mark stays until
/// a beam passes through it again.
class PeopleSight {
 public:
  /// `map` must outlive it: a beam that ends at a wall's cells says nothing about people.
  explicit PeopleSight(const sim::OccupancyMap& map) : map_(map) {}

  /// A beam met somebody; map frame and costmap frame [m].
  void add(std::uint32_t id, const Point& in_map, const Point& in_costmap);

  /// Forgets what the costmap no longer marks, and all but one point of a cell.
  void keep_marked(const GridView& costmap);

  /// The true state of everybody, without any deviation; `map_in_costmap`: the map's frame in the costmap's.
  MovingObstacleEstimates truth(const std::vector<sim::Mover>& movers, const sim::Pose& map_in_costmap) const;

 private:
  const sim::OccupancyMap& map_;
  std::map<std::uint32_t, std::vector<Point>> points_;  // costmap frame [m]
};

}  // namespace drive
}  // namespace hidwa_local_planner
