// SPDX-License-Identifier: BSD-3-Clause
// How far the robot is from obstacles, cell by cell. For a convex outline by separating axes: the largest gap between
// the two shapes over the axes that stand on their sides. That is the distance, or less where two corners are nearest.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/naive_collision.hpp"

namespace hidwa_local_planner::test {

/// Both shapes as their corners: how far `other` lies beyond `one` along an axis of length 1.
inline double naive_gap_along(const Point& axis, const Polygon& one, const Polygon& other) {
  double most = -INFINITY, least = INFINITY;
  for (const Point& p : one) most = std::max(most, axis.dot(p));
  for (const Point& p : other) least = std::min(least, axis.dot(p));
  return least - most;
}

inline Polygon naive_square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

/// The outer normals of the sides, each side beginning at the corner of its number.
inline std::vector<Point> naive_normals(const Polygon& p) {
  const double left_round = naive_twice_area(p) > 0.0 ? 1.0 : -1.0;
  std::vector<Point> normals;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Point d = (p[(k + 1) % p.size()] - p[k]).normalized();
    normals.emplace_back(left_round * d.y(), -left_round * d.x());
  }
  return normals;
}

inline bool naive_convex(const Polygon& p) {
  const std::vector<Point> normals = naive_normals(p);
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (const Point& q : p) {
      if (normals[i].dot(q - p[i]) > 1e-12) return false;
    }
  }
  return true;
}

/// `axes`: the normals of both.
inline double naive_separating_gap(const std::vector<Point>& axes, const Polygon& convex, const Polygon& square) {
  double most = -INFINITY;
  for (const Point& axis : axes) most = std::max(most, naive_gap_along(axis, convex, square));
  return most;
}

/// From a point to the part of a line between two others.
inline double naive_to_segment(const Point& p, const Point& a, const Point& b) {
  const double along = (p - a).dot(b - a) / (b - a).squaredNorm();
  return (p - (a + std::max(0.0, std::min(1.0, along)) * (b - a))).norm();
}

/// Between two polygons that share no area: from a corner of either to a side of the other.
inline double naive_polygon_distance(const Polygon& one, const Polygon& other) {
  double least = INFINITY;
  for (std::size_t i = 0; i < one.size(); ++i) {
    for (std::size_t k = 0; k < other.size(); ++k) {
      least = std::min(least, naive_to_segment(one[i], other[k], other[(k + 1) % other.size()]));
      least = std::min(least, naive_to_segment(other[k], one[i], one[(i + 1) % one.size()]));
    }
  }
  return least;
}

/// To the nearest obstacle, or the map's edge [m]; `most` where nothing is nearer. 0 or less where the robot overlaps
/// one. Of a disc the centre alone minds inscribed cells.
inline double naive_gap(const GridView& grid, const NaiveBody& body, const Pose2& pose, bool unknown_is_obstacle,
                        double most) {
  const Polygon placed = naive_place(body.corners, pose);
  const bool disc = body.radius > 0.0, convex = !disc && naive_convex(body.corners);
  const double right = grid.origin_x + grid.size_x * grid.resolution,
               top = grid.origin_y + grid.size_y * grid.resolution;
  std::vector<Point> axes{{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}};
  for (const Point& normal : naive_normals(placed)) axes.push_back(normal);
  double least = most;
  for (const Point& p : disc ? Polygon{{pose.x, pose.y}} : placed) {
    const double inside = std::min({p.x() - grid.origin_x, right - p.x(), p.y() - grid.origin_y, top - p.y()});
    least = std::min(least, inside - body.radius);
  }
  // Only cells that can be near enough: where corners are nearest, the gap is up to sqrt(2) less than the distance.
  const double around = naive_outer_radius(body) + 1.5 * std::max(most, 0.0);
  for (int j = 0; j < grid.size_y; ++j) {
    const double y = grid.origin_y + j * grid.resolution;
    if (std::abs(y - pose.y) > around + grid.resolution) continue;
    for (int i = 0; i < grid.size_x; ++i) {
      const double x = grid.origin_x + i * grid.resolution;
      if (std::abs(x - pose.x) > around + grid.resolution) continue;
      if (naive_to_square(pose, x, y, grid.resolution) > around) continue;
      const std::uint8_t value = grid.costs[j * grid.size_x + i];
      if (disc && value == 253) least = std::min(least, naive_to_square(pose, x, y, grid.resolution));
      if (!naive_is_obstacle(value, unknown_is_obstacle)) continue;
      if (disc) {
        least = std::min(least, naive_to_square(pose, x, y, grid.resolution) - body.radius);
      } else if (convex) {
        least = std::min(least, naive_separating_gap(axes, placed, naive_square(x, y, grid.resolution)));
      } else {
        const bool shares = naive_shared_area(placed, x, y, grid.resolution) > 0.0;
        const Polygon square = naive_square(x, y, grid.resolution);
        least = std::min(least, shares ? 0.0 : naive_polygon_distance(placed, square));
      }
    }
  }
  return least;
}

}  // namespace hidwa_local_planner::test
