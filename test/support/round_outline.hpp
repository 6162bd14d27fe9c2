// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::test {

/// A circle of this radius [m] as costmap_2d makes it of robot_radius.
inline Polygon round_outline(double radius, int corners = 16) {
  Polygon outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * M_PI * i / corners;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

}  // namespace hidwa_local_planner::test
