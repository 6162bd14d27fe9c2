// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Core>

namespace hidwa_local_planner {
namespace sim {

/// A pose in the plane.
struct Pose {
  double x = 0.0;      // [m]
  double y = 0.0;      // [m]
  double theta = 0.0;  // [rad]
};

/// Corners of a simple polygon, in order, either way round; the last joins the first [m].
using Polygon = std::vector<Eigen::Vector2d>;

/// The polygon given in the frame of `pose`, in the frame that `pose` is given in.
Polygon transformed(const Polygon& polygon, const Pose& pose);

/// Regular polygon of `corners` corners on a circle of `radius` [m] round the origin.
Polygon circle_polygon(double radius, int corners = 64);

/// Distance of the farthest corner from the origin [m].
double circumscribed_radius(const Polygon& polygon);

/// Smallest rectangle along the axes that holds a polygon.
struct Box {
  Eigen::Vector2d low;   // [m]
  Eigen::Vector2d high;  // [m]
};

/// Bounds of a polygon of one corner or more.
Box bounds(const Polygon& polygon);

/// Whether the point lies inside (on the border: either answer).
bool contains(const Polygon& polygon, const Eigen::Vector2d& point);

/// Whether two closed segments share a point.
bool segments_touch(const Eigen::Vector2d& a0, const Eigen::Vector2d& a1, const Eigen::Vector2d& b0,
                    const Eigen::Vector2d& b1);

/// Whether two polygons share a point: borders that cross or touch, or one inside the other.
bool touch(const Polygon& a, const Polygon& b);

/// From a point to the nearest one of a segment [m].
double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// Along a ray of direction (c, s) to where it enters a disc, whose centre is at `to` from its origin [m]; 0 inside;
/// infinite where it passes by.
inline double ray_to_disc(const Eigen::Vector2d& to, double c, double s, double radius) {
  if (to.squaredNorm() <= radius * radius) return 0.0;
  const double along = to.x() * c + to.y() * s, across = to.y() * c - to.x() * s;
  if (along < 0.0 || std::abs(across) > radius) return std::numeric_limits<double>::infinity();
  return std::max(0.0, along - std::sqrt(radius * radius - across * across));
}

/// Pose of `b`, given in the frame of pose `a`, in the frame that `a` is given in.
Pose compose(const Pose& a, const Pose& b);

/// The pose whose composition with `a` is the identity.
Pose inverse(const Pose& a);

/// Angle brought into (-pi, pi] [rad].
double normalized(double angle);

}  // namespace sim
}  // namespace hidwa_local_planner
