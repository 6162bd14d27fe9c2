// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Core>

namespace hidwa_local_planner {

using Point = Eigen::Vector2d;       // [m]
using Polygon = std::vector<Point>;  // corners in order, closed implicitly [m]

/// A planar pose, REP-103: x forward, y left, theta counter-clockwise.
struct Pose2 {
  double x = 0.0;      // [m]
  double y = 0.0;      // [m]
  double theta = 0.0;  // [rad]
};

/// A velocity of a differential-drive robot in its own frame.
struct Twist2 {
  double v = 0.0;      // forward [m/s]
  double omega = 0.0;  // counter-clockwise [rad/s]
};

inline bool operator==(const Twist2& a, const Twist2& b) { return a.v == b.v && a.omega == b.omega; }
inline bool is_finite(const Twist2& u) { return std::isfinite(u.v) && std::isfinite(u.omega); }
inline bool is_finite(const Pose2& q) { return std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.theta); }

/// The angle in (-pi, pi] that equals `angle` [rad] up to whole turns.
inline double wrap_angle(double angle) {
  constexpr double kTurn = 2.0 * M_PI;
  // std::remainder() is slow. Within half a turn, and one turn off, these are the same bits: differences are exact.
  if (angle > -M_PI && angle <= M_PI) return angle;
  if (angle > M_PI && angle < 3.0 * M_PI) return angle - kTurn;
  if (angle < -M_PI && angle > -3.0 * M_PI) return -(-angle - kTurn);
  const double wrapped = std::remainder(angle, kTurn);
  return wrapped <= -M_PI ? M_PI : wrapped;
}

inline double distance(const Pose2& a, const Pose2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace hidwa_local_planner
