// SPDX-License-Identifier: BSD-3-Clause
// The robot against obstacle cells, the slow way: areas by clipping, nearest points. Shares nothing with the
// core but its plain types.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::test {

/// Corners, or a disc where radius > 0.
struct NaiveBody {
  Polygon corners;      // robot frame [m]
  double radius = 0.0;  // [m]
};

/// Above 0 where the corners go left round [m^2].
inline double naive_twice_area(const Polygon& p) {
  double twice = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point& a = p[i];
    const Point& b = p[(i + 1) % p.size()];
    twice += a.x() * b.y() - b.x() * a.y();
  }
  return twice;
}
inline double naive_area(const Polygon& p) { return std::abs(naive_twice_area(p)) / 2.0; }

/// Keeps what lies where inside(point) >= 0 (Sutherland and Hodgman 1974). `inside` is a signed distance.
/// Where the polygon is not convex, parts stay joined by lines of no width, which add no area.
inline Polygon naive_clip(const Polygon& p, const std::function<double(const Point&)>& inside) {
  Polygon kept;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point& a = p[i];
    const Point& b = p[(i + 1) % p.size()];
    const double da = inside(a), db = inside(b);
    if (da >= 0.0) kept.push_back(a);
    if ((da >= 0.0) != (db >= 0.0)) kept.push_back(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

/// Area [m^2] that a simple polygon shares with the square [x, x + side] x [y, y + side].
inline double naive_shared_area(const Polygon& polygon, double x, double y, double side) {
  Polygon p = naive_clip(polygon, [&](const Point& q) { return q.x() - x; });
  p = naive_clip(p, [&](const Point& q) { return x + side - q.x(); });
  p = naive_clip(p, [&](const Point& q) { return q.y() - y; });
  p = naive_clip(p, [&](const Point& q) { return y + side - q.y(); });
  return naive_area(p);
}

inline Polygon naive_place(const Polygon& corners, const Pose2& pose) {
  Polygon placed;
  for (const Point& p : corners) {
    placed.emplace_back(pose.x + p.x() * std::cos(pose.theta) - p.y() * std::sin(pose.theta),
                        pose.y + p.x() * std::sin(pose.theta) + p.y() * std::cos(pose.theta));
  }
  return placed;
}

inline double naive_outer_radius(const NaiveBody& body) {
  double radius = body.radius;
  for (const Point& p : body.corners) radius = std::max(radius, std::hypot(p.x(), p.y()));
  return radius;
}

inline bool naive_is_obstacle(std::uint8_t value, bool unknown_is_obstacle) {
  return value == 254 || (value == 255 && unknown_is_obstacle);
}

/// From a point to a square.
inline double naive_to_square(const Pose2& pose, double x, double y, double side) {
  const double nearest_x = std::min(std::max(pose.x, x), x + side);
  const double nearest_y = std::min(std::max(pose.y, y), y + side);
  return std::hypot(nearest_x - pose.x, nearest_y - pose.y);
}

/// How deep the robot reaches into the worst obstacle cell, or over the map's edge: a length [m] for a disc,
/// the root of an area for a polygon, so that 0 is free and rounding stays near 0.
inline double naive_overlap(const GridView& grid, const NaiveBody& body, const Pose2& pose, bool unknown_is_obstacle,
                            int* cells = nullptr) {
  const double width = grid.size_x * grid.resolution, height = grid.size_y * grid.resolution;
  const Polygon placed = naive_place(body.corners, pose);
  const double outer_radius = naive_outer_radius(body), outer = outer_radius + 2.0 * grid.resolution;
  double worst = 0.0;
  for (const Point& p : placed) {
    worst = std::max({worst, grid.origin_x - p.x(), grid.origin_y - p.y(), p.x() - grid.origin_x - width,
                      p.y() - grid.origin_y - height});
  }
  if (body.radius > 0.0) {
    worst = std::max({worst, grid.origin_x - (pose.x - body.radius), grid.origin_y - (pose.y - body.radius),
                      pose.x + body.radius - grid.origin_x - width, pose.y + body.radius - grid.origin_y - height});
  }
  // Only cells that can be near enough.
  const auto nearest = [&](double value, double origin, int size) {
    return std::min(std::max(static_cast<int>(std::floor((value - origin) / grid.resolution)), 0), size - 1);
  };
  const int i_end = nearest(pose.x + outer, grid.origin_x, grid.size_x);
  const int j_end = nearest(pose.y + outer, grid.origin_y, grid.size_y);
  for (int j = nearest(pose.y - outer, grid.origin_y, grid.size_y); j <= j_end; ++j) {
    for (int i = nearest(pose.x - outer, grid.origin_x, grid.size_x); i <= i_end; ++i) {
      if (!naive_is_obstacle(grid.costs[j * grid.size_x + i], unknown_is_obstacle)) continue;
      const double x = grid.origin_x + i * grid.resolution, y = grid.origin_y + j * grid.resolution;
      double depth = 0.0;
      const double from_centre = naive_to_square(pose, x, y, grid.resolution);
      if (from_centre >= outer_radius) continue;
      if (body.radius > 0.0) {
        depth = body.radius - from_centre;
      } else {
        depth = std::sqrt(naive_shared_area(placed, x, y, grid.resolution));
      }
      worst = std::max(worst, depth);
      if (cells != nullptr && depth > 0.0) ++*cells;
    }
  }
  return worst;
}

/// The planner's rule for the centre's cell of a disc: inscribed counts as a collision, and so does no cell
/// at all.
inline bool naive_centre_inscribed(const GridView& grid, const NaiveBody& body, const Pose2& pose) {
  if (body.radius <= 0.0) return false;
  const int i = static_cast<int>(std::floor((pose.x - grid.origin_x) / grid.resolution));
  const int j = static_cast<int>(std::floor((pose.y - grid.origin_y) / grid.resolution));
  if (i < 0 || j < 0 || i >= grid.size_x || j >= grid.size_y) return true;
  const int value = grid.costs[j * grid.size_x + i];
  return value == 253;
}

}  // namespace hidwa_local_planner::test
