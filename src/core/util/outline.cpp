// SPDX-License-Identifier: BSD-3-Clause
#include "core/util/outline.hpp"

namespace hidwa_local_planner {

bool contains(const Polygon& outline, const Point& point) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (crosses_positive_x(outline[i] - point, outline[(i + 1) % outline.size()] - point)) inside = !inside;
  }
  return inside;
}

double signed_area(const Polygon& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) twice += cross(outline[i], outline[(i + 1) % outline.size()]);
  return 0.5 * twice;
}

Polygon without_repeats(const Polygon& outline) {
  Polygon kept;
  for (const Point& p : outline) {
    if (kept.empty() || !((p - kept.back()).norm() <= 1e-9)) kept.push_back(p);
  }
  while (kept.size() > 1 && (kept.front() - kept.back()).norm() <= 1e-9) kept.pop_back();
  return kept;
}

Polygon convex_hull(Polygon points) {
  constexpr double kStraight = 1e-9;  // a corner that spans a smaller parallelogram is straight [m^2]
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;
  Polygon hull;
  // The lower side from left to right, then the upper one back (monotone chain).
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    const auto no_corner = [&hull](const Point& point) {
      const Point& before = hull[hull.size() - 2];
      return cross(hull.back() - before, point - before) <= kStraight;
    };
    for (const Point& point : points) {
      while (hull.size() >= begin + 2 && no_corner(point)) hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();  // where the other side begins
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace hidwa_local_planner
