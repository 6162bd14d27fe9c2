// SPDX-License-Identifier: BSD-3-Clause
// An outline grown by a distance, by angles: the twin of Footprint::padded.
#pragma once

#include <cmath>

#include "support/naive_collision.hpp"

namespace hidwa_local_planner::test {

inline double naive_turn(const Point& a, const Point& b, const Point& c) {  // [rad], to the left
  return std::atan2((b.x() - a.x()) * (c.y() - b.y()) - (b.y() - a.y()) * (c.x() - b.x()), (b - a).dot(c - b));
}
inline bool naive_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto left = [](const Point& p, const Point& q, const Point& r) { return naive_turn(p, q, r) > 0.0; };
  return left(a, b, c) != left(a, b, d) && left(c, d, a) != left(c, d, b);
}
inline bool naive_crossing(const Polygon& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const bool neighbours = i == j || (i + 1) % n == j || (j + 1) % n == i;
      if (!neighbours && naive_cross(p[i], p[(i + 1) % n], p[j], p[(j + 1) % n])) return true;
    }
  }
  return false;
}

/// Corners that have everything to their left, seen from the corner before: gift wrapping.
inline Polygon naive_hull(const Polygon& points) {
  Point first = points.front();
  for (const Point& p : points) {
    if (p.y() < first.y() || (p.y() == first.y() && p.x() < first.x())) first = p;
  }
  Polygon hull{first};
  do {
    Point next = hull.back();
    for (const Point& p : points) {
      const Point &a = hull.back(), &b = next;
      const double side = (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
      if (b == a || side < -1e-12 || (std::abs(side) <= 1e-12 && (p - a).norm() > (b - a).norm())) next = p;
    }
    hull.push_back(next);
  } while (hull.back() != first);
  hull.pop_back();
  return hull;
}

/// Leftwards around. Each corner goes along the middle of its outer angle; one below 60 degrees becomes two.
inline Polygon naive_moved(const Polygon& p, double padding, bool& folded) {
  const std::size_t n = p.size();
  Polygon moved;
  std::vector<std::size_t> side_of;  // that begins at a moved corner; n where the tip was cut off
  for (std::size_t i = 0; i < n; ++i) {
    const Point &before = p[(i + n - 1) % n], &here = p[i], &after = p[(i + 1) % n];
    const double turn = naive_turn(before, here, after);
    const double outwards = std::atan2(here.y() - before.y(), here.x() - before.x()) - M_PI / 2;
    const auto put = [&](double angle, double half) {
      moved.push_back(here + padding / std::cos(half) * Point(std::cos(angle), std::sin(angle)));
    };
    if (turn > 2.0 * M_PI / 3.0) {
      put(outwards + turn / 4, turn / 4);
      side_of.push_back(n);
      put(outwards + 3 * turn / 4, turn / 4);
    } else {
      put(outwards + turn / 2, turn / 2);
    }
    side_of.push_back(i);
  }
  for (std::size_t k = 0; k < moved.size(); ++k) {
    if (side_of[k] == n) continue;
    const Point was = p[(side_of[k] + 1) % n] - p[side_of[k]];
    if ((moved[(k + 1) % moved.size()] - moved[k]).dot(was) <= 0.0) folded = true;
  }
  return moved;
}

/// Everything within `padding` [m] of the body. Corners in any order, an area; a dent that closes is filled.
inline NaiveBody naive_padded(const NaiveBody& body, double padding) {
  if (body.radius > 0.0) return {{}, body.radius + padding};
  const bool left_round = naive_twice_area(body.corners) > 0.0;
  const Polygon left = left_round ? body.corners : Polygon(body.corners.rbegin(), body.corners.rend());
  bool folded = false;
  const Polygon moved = naive_moved(left, padding, folded);
  if (padding == 0.0) return body;
  return {folded || naive_crossing(moved) ? naive_moved(naive_hull(left), padding, folded) : moved, 0.0};
}

}  // namespace hidwa_local_planner::test
