// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/util/outline.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Velocities that a motion may have, each axis on its own: `least` is not above 0, `most` not below [m/s, rad/s].
struct VelocityRange {
  Twist2 least, most;

  void include(const Twist2& u) {
    least = {std::min(least.v, u.v), std::min(least.omega, u.omega)};
    most = {std::max(most.v, u.v), std::max(most.omega, u.omega)};
  }
};

/// Whether a place of the outline is within `radius` [m] of `point` (robot frame, outside of the outline) that may move
/// outwards, along its side's normal, faster than `speed` [m/s].
inline bool advances_near(const Footprint& footprint, const VelocityRange& u, double speed, const Point& point,
                          double radius) {
  if (footprint.is_circle()) {
    // Of a circle the places within an angle of where it drives to.
    const auto near = [&](double driven, double ahead) {
      if (driven <= speed) return false;
      const double most = std::acos(speed / driven);
      const double off = std::max(0.0, std::abs(std::atan2(point.y(), ahead * point.x())) - most);
      const Point at(footprint.radius() * std::cos(off), footprint.radius() * std::sin(off));
      return (Point(point.norm(), 0.0) - at).norm() <= radius;
    };
    return near(u.most.v, 1.0) || near(-u.least.v, -1.0);
  }
  const Polygon& corners = footprint.outline();
  const auto near = [&](const Point& a, const Point& b) {
    return std::sqrt(squared_distance_to_segment(point, a, b)) <= radius;
  };
  const double around = signed_area(corners) > 0.0 ? 1.0 : -1.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& a = corners[i];
    const Point& b = corners[(i + 1) % corners.size()];
    const double length = (b - a).norm();
    if (length <= 0.0) continue;
    const Point along = (b - a) / length;
    const Point normal(around * along.y(), -around * along.x());
    const double left = speed - std::max(u.most.v * normal.x(), u.least.v * normal.x());
    if (left < 0.0) {
      if (near(a, b)) return true;
      continue;
    }
    // A turn moves a place outwards by omega times its lever, which changes evenly along the side.
    const auto lever = [&normal](const Point& p) { return p.x() * normal.y() - p.y() * normal.x(); };
    for (const double omega : {u.least.omega, u.most.omega}) {
      const double from = omega * lever(a) - left, to = omega * lever(b) - left;
      if (from <= 0.0 && to <= 0.0) continue;
      const Point zero = from * to < 0.0 ? Point(a + from / (from - to) * (b - a)) : a;
      if (near(from > 0.0 ? a : zero, to > 0.0 ? b : zero)) return true;
    }
  }
  return false;
}

}  // namespace hidwa_local_planner
