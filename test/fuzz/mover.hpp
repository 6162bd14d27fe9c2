// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "fuzz/input.hpp"
#include "hidwa_local_planner/core/moving_obstacle.hpp"

namespace hidwa_local_planner::fuzz {

/// Something that moves, mostly at most `reach` [m] off on each axis and with a velocity not surer than `doubt` [m/s];
/// without points.
inline MovingObstacleEstimate mover_of(Input& input, double reach, double doubt) {
  MovingObstacleEstimate mover;
  mover.position = {input.number(-reach, reach), input.number(-reach, reach)};
  mover.velocity = {input.number(-2.0, 2.0), input.number(-2.0, 2.0)};
  mover.radius = input.number(0.0, 0.5);
  mover.position_deviation = input.number(0.0, 0.2);
  mover.velocity_deviation = input.number(0.0, doubt);
  mover.age = input.number(0.0, 0.5);
  return mover;
}

}  // namespace hidwa_local_planner::fuzz
