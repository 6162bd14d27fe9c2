// SPDX-License-Identifier: BSD-3-Clause
// Geometry of outlines.
#pragma once

#include <algorithm>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Whether a side crosses the x axis to the right of the origin: upwards with the origin to its left, or downwards to
/// its right.
inline bool crosses_positive_x(const Point& a, const Point& b) {
  return (a.y() > 0.0) != (b.y() > 0.0) && (cross(a, b) > 0.0) == (b.y() > a.y());
}

/// From a point to the nearest one of the straight line from `a` to `b` [m^2].
inline double squared_distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * d).squaredNorm();
}

/// Whether a point lies inside a polygon.
bool contains(const Polygon& outline, const Point& point);
/// The area inside a polygon, negative where its corners go right round [m^2].
double signed_area(const Polygon& outline);
/// Without corners that lie on the one before them. What is not a number repeats nothing.
Polygon without_repeats(const Polygon& outline);
/// The corners of the convex hull [m], counter-clockwise, without those on a straight side; of points on a line its
/// ends.
Polygon convex_hull(Polygon points);

}  // namespace hidwa_local_planner
