// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "sim/distance_field.hpp"
#include "sim/occupancy_map.hpp"
#include "sim/random.hpp"

namespace hidwa_local_planner {
namespace sim {

/// A planar laser scanner. Beams are spread evenly over the field of view: both ends included, or, for a full
/// turn, without the second end, which is the first.
struct LaserSpec {
  int beams = 720;
  double field_of_view = 6.283185307179586;  // [rad], centred on the sensor's x axis
  double range_min = 0.05;                   // [m]
  double range_max = 10.0;                   // [m]
  double noise = 0.0;                        // [m], standard deviation of a range

  double angle_min() const { return -0.5 * field_of_view; }  // [rad]
  double angle_increment() const;                            // [rad]
};

/// One scan; `range` tells the true range [m] in a direction [rad, map frame], infinite where there is nothing. Nothing
/// within range: +infinity; nearer than range_min: -infinity (REP 117).
void scan(const std::function<double(double angle)>& range, const LaserSpec& spec, double sensor_heading,
          Random& random, std::vector<float>& ranges);

/// Distance from (x, y) in direction `angle` [rad, map frame] to where a ray enters the first occupied cell of a map
/// [m]; infinite if none within `range_max` [m]. 0 inside an occupied cell. Nothing outside the map is occupied.
/// `to_obstacles`, the distances of the map, makes it faster and changes nothing.
double range_in(const OccupancyMap& map, double x, double y, double angle, double range_max,
                const DistanceField* to_obstacles = nullptr);

}  // namespace sim
}  // namespace hidwa_local_planner
