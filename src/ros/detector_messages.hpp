// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <topic_tools/shape_shifter.h>

#include "hidwa_local_planner/MovingObstacles.h"

namespace hidwa_local_planner {

struct DetectedObstacles {
  MovingObstacles::ConstPtr message;  // null where there is a fault
  std::string fault;                  // why it cannot be read, with the remedy
};

/// What moves, from a message of a type that detectors send: hidwa_local_planner/MovingObstacles as it is,
/// people_msgs/People and costmap_converter/ObstacleArrayMsg converted. Their packages need not be installed. Throws
/// nothing.
///
/// What these types do not tell is taken for: a radius of 0.3 m (people), standard deviations of 0.05 m and 0.15 m/s.
/// An obstacle's disc holds its polygon. Where the velocity's covariance is known, its deviation comes from it; that of
/// costmap_converter itself is 1 whatever it knows, and counts as unknown. Obstacles slower than 1 mm/s are left to the
/// costmap, that the converter has them from.
DetectedObstacles read_detected(const topic_tools::ShapeShifter& from);

}  // namespace hidwa_local_planner
