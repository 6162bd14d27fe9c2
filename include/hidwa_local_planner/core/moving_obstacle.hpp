// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Something that moves, as it was estimated `age` ago: a disc with a velocity.
struct MovingObstacleEstimate {
  std::uint32_t id = 0;             // of the track
  Point position{0.0, 0.0};         // of its centre, costmap frame [m]
  Point velocity{0.0, 0.0};         // relative to the ground, costmap frame [m/s]
  double radius = 0.0;              // of a disc that holds all of it [m]
  double position_deviation = 0.0;  // standard deviation along any axis [m]
  double velocity_deviation = 0.0;  // standard deviation along any axis [m/s]
  double age = 0.0;                 // of the estimate at the cycle's start [s]
  // Where a sensor sees it, and saw free space before, costmap frame [m]. These places leave the planner's copy of the
  // costmap: the disc counts already.
  std::vector<Point> points;

  /// Where its centre is at the cycle's start if it keeps its velocity, costmap frame [m].
  Point position_now() const { return position + age * velocity; }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.id, self.position, self.velocity, self.radius, self.position_deviation, self.velocity_deviation, self.age,
       self.points);
  }
};

using MovingObstacleEstimates = std::vector<MovingObstacleEstimate>;

}  // namespace hidwa_local_planner
