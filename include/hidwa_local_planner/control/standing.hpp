// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Whether a robot with this measured velocity [m/s, rad/s] counts as standing: trans_stopped_velocity and
/// rot_stopped_velocity.
inline bool stands(const Twist2& velocity, const Parameters& parameters) {
  return std::abs(velocity.v) <= parameters.trans_stopped_velocity &&
         std::abs(velocity.omega) <= parameters.rot_stopped_velocity;
}

}  // namespace hidwa_local_planner
