// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// From a point to the nearest one of the straight line from `a` to `b` [m^2].
inline double squared_distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * d).squaredNorm();
}

}  // namespace hidwa_local_planner
