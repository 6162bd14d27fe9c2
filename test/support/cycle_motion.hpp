// SPDX-License-Identifier: BSD-3-Clause
// For checks of one command's manoeuvre until rest.
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "core/motion/brake_manoeuvre.hpp"
#include "core/motion/cycle_start.hpp"
#include "hidwa_local_planner/core/footprint.hpp"

namespace hidwa_local_planner::test {

/// The start of a cycle in which the robot drives with `now`. Until its command takes effect it goes on as it was told.
struct CycleMotion {
  CycleMotion(const Parameters& parameters, const Twist2& now, const Pose2& pose = {})
      : CycleMotion(parameters, now, pose, now) {}
  CycleMotion(const Parameters& parameters, const Twist2& now, const Pose2& pose, const Twist2& told)
      : pending(PendingMotion(told, parameters.control_latency)) {
    start.limits = VelocityLimits::from(parameters);
    start.pose = start.origin = pose;
    start.reference = start.velocity = now;
    start.pending = &pending;
  }
  CycleMotion(const CycleMotion&) = delete;
  CycleMotion& operator=(const CycleMotion&) = delete;

  /// From where the pose was measured. Between two poses no point within `radius` moves more than `spacing` [m], and no
  /// more than `step` [s] pass.
  ManoeuvreRoller roller(double radius, double spacing, double step) const {
    return {start.limits, radius, spacing, TurnedPose::of(start.origin), step};
  }

  PendingMotionSet pending;
  CycleStart start;
};

/// A place in the robot's frame.
inline Point in_frame_of(const Pose2& robot, const Point& place) {
  const double dx = place.x() - robot.x, dy = place.y() - robot.y;
  const double c = std::cos(robot.theta), s = std::sin(robot.theta);
  return {c * dx + s * dy, c * dy - s * dx};
}

/// What is touched on the way to rest must be refused, and what stays farther away than every allowance must not.
struct GapTally {
  int touched = 0, free = 0;

  void add(double gap, double allowance, bool passes) {
    if (gap <= 0.0) {
      EXPECT_FALSE(passes) << gap;
      ++touched;
    }
    if (gap > allowance) {
      EXPECT_TRUE(passes) << gap;
      ++free;
    }
  }
};

}  // namespace hidwa_local_planner::test
