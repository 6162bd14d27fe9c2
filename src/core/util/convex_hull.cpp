// SPDX-License-Identifier: BSD-3-Clause
#include "core/util/convex_hull.hpp"

#include <algorithm>

namespace hidwa_local_planner {
namespace {

double cross(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace

Polygon convex_hull(Polygon points) {
  constexpr double kStraight = 1e-9;  // twice the area of a corner that is none [m^2]
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;
  Polygon hull;
  // The lower side from left to right, then the upper one back (monotone chain).
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = hull.size();
    for (const Point& point : points) {
      while (hull.size() >= begin + 2 && cross(hull[hull.size() - 2], hull.back(), point) <= kStraight) hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();  // where the other side begins
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

}  // namespace hidwa_local_planner
