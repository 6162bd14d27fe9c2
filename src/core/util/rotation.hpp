// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// A direction, or a turn from one to another.
struct Rotation {
  double c = 1.0;  // cosine
  double s = 0.0;  // sine

  /// Exact to the last bits; small angles [rad], of which rollouts consist, take a few multiplications.
  static Rotation of(double angle) {
    if (std::abs(angle) > 0.05) return {std::cos(angle), std::sin(angle)};
    const double a2 = angle * angle;  // the next terms are below 1e-18
    return {1.0 - a2 * (1.0 / 2.0) * (1.0 - a2 * (1.0 / 12.0) * (1.0 - a2 * (1.0 / 30.0) * (1.0 - a2 * (1.0 / 56.0)))),
            angle * (1.0 - a2 * (1.0 / 6.0) * (1.0 - a2 * (1.0 / 20.0) * (1.0 - a2 * (1.0 / 42.0))))};
  }
  /// To the last bit, of any angle [rad].
  static Rotation direction(double angle) { return {std::cos(angle), std::sin(angle)}; }
  Rotation turned(const Rotation& by) const { return {c * by.c - s * by.s, s * by.c + c * by.s}; }
  /// Where a point of the robot's frame is when the robot stands at (x, y) in this direction [m].
  Point placed(double x, double y, double ahead, double left) const {
    return {x + c * ahead - s * left, y + s * ahead + c * left};
  }
  Point apply(const Point& p) const { return {c * p.x() - s * p.y(), s * p.x() + c * p.y()}; }
  Point undo(const Point& p) const { return {c * p.x() + s * p.y(), c * p.y() - s * p.x()}; }
};

/// A pose and its heading.
struct TurnedPose {
  Pose2 pose;
  Rotation heading;

  static TurnedPose of(const Pose2& pose) { return {pose, Rotation::direction(pose.theta)}; }
  /// A point of the frame of the pose, as it lies in the robot's frame [m].
  Point seen(const Point& p) const { return heading.undo({p.x() - pose.x, p.y() - pose.y}); }
};

}  // namespace hidwa_local_planner
