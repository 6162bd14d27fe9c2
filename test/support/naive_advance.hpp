// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/movers/advance.hpp"

namespace hidwa_local_planner::test {

/// How far a point (robot frame) is from the nearest place of the outline that may move outwards faster than `speed`,
/// of places `apart` from each other [m]; infinite where none may. Outwards is where the outline does not lie.
inline double naive_distance_to_advancing(const Footprint& footprint, const VelocityRange& u, double speed,
                                          const Point& point, double apart) {
  Polygon corners = footprint.outline();
  if (footprint.is_circle()) {
    const int count = static_cast<int>(2.0 * M_PI * footprint.radius() / apart);
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * M_PI * k / count;
      corners.emplace_back(footprint.radius() * std::cos(angle), footprint.radius() * std::sin(angle));
    }
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i], way = corners[(i + 1) % corners.size()] - a;
    Point normal(way.y() / way.norm(), -way.x() / way.norm());
    if (footprint.distance_to(a + 0.5 * way + 1e-6 * normal) < 0.0) normal = -normal;
    const int parts = 1 + static_cast<int>(way.norm() / apart);
    for (int k = 0; k <= parts; ++k) {
      const Point at = a + static_cast<double>(k) / parts * way;
      if (footprint.is_circle()) normal = at / at.norm();
      double fastest = 0.0;
      for (const double v : {u.least.v, u.most.v}) {
        for (const double omega : {u.least.omega, u.most.omega}) {
          fastest = std::max(fastest, normal.dot(Point(v - omega * at.y(), omega * at.x())));
        }
      }
      if (fastest > speed) nearest = std::min(nearest, (at - point).norm());
    }
  }
  return nearest;
}

}  // namespace hidwa_local_planner::test
