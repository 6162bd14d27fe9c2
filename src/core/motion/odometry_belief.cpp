// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/odometry_belief.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/same_time.hpp"

namespace hidwa_local_planner {

Twist2 reading_tolerance(const Parameters& p, const Twist2& last) {
  // Inside the motors' dead band the robot does not move yet although the command grows: such a reading agrees.
  const double omega = std::abs(last.omega);
  const double standing = omega <= std::max(p.min_in_place_vel_theta, p.min_vel_theta) ? omega : 0.0;
  return {p.velocity_reference_tolerance_x, p.velocity_reference_tolerance_theta + standing};
}

bool faster_than_explained(double measured, const Interval& explained, double tolerance) {
  return measured < std::min(explained.lo, 0.0) - tolerance || measured > std::max(explained.hi, 0.0) + tolerance;
}

OdometryReading AxisBelief::judge(double now, double measured, const Interval& explained, double tolerance,
                                  const AxisLimits& axis) {
  if (!faster_than_explained(measured, explained, tolerance)) {
    forget();
    const bool agrees = measured >= explained.lo - tolerance && measured <= explained.hi + tolerance;
    return agrees ? OdometryReading::agrees : OdometryReading::slower;
  }
  const auto follows = [&](double before, double time) {
    const double change = tolerance + std::max(axis.acc, axis.braking) * std::max(now - time, 0.0);
    return std::abs(measured - before) <= change;
  };
  if (!fast_ || now < since_ || !follows(last_, last_time_)) since_ = now;
  const bool known = sure_ && now >= believed_time_ && now - believed_time_ <= kLongEnough + kSameTime;
  const bool goes_on = known && follows(believed_, believed_time_);
  fast_ = true;
  last_ = measured;
  last_time_ = now;
  sure_ = known;
  if (goes_on || now - since_ >= kLongEnough - kSameTime) {
    sure_ = true;
    believed_ = measured;
    believed_time_ = now;
  }
  return sure_ ? OdometryReading::faster : OdometryReading::doubted;
}

}  // namespace hidwa_local_planner
