// SPDX-License-Identifier: BSD-3-Clause
#include "input/joystick_map.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner::input {

double map_axis(double deflection, double dead_zone, double exponent, double maximum) {
  const double size = std::min(std::abs(deflection), 1.0);
  if (!(size > dead_zone)) return 0.0;  // what is not a number is no deflection either
  return std::copysign(std::pow(size, exponent), deflection) * maximum;
}

}  // namespace hidwa_local_planner::input
