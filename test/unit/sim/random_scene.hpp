// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sim/laser.hpp"
#include "sim/occupancy_map.hpp"
#include "sim/polygon.hpp"
#include "sim/random.hpp"

namespace hidwa_local_planner {
namespace sim {

/// A map whose cells are occupied with probability `density`, each by itself.
inline OccupancyMap random_map(Random& random, int width, int height, double density) {
  OccupancyMap map = make_map(width, height, 0.05, -1.3, 0.7);
  for (Cell& cell : map.cells) {
    if (random.uniform() < density) cell = Cell::kOccupied;
  }
  return map;
}

/// One scan in a map, from `sensor` (map frame).
inline void scan(const OccupancyMap& map, const LaserSpec& spec, const Pose& sensor, Random& random,
                 std::vector<float>& ranges) {
  scan([&](double angle) { return range_in(map, sensor.x, sensor.y, angle, spec.range_max); }, spec, sensor.theta,
       random, ranges);
}

inline double uniform(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }

}  // namespace sim
}  // namespace hidwa_local_planner
