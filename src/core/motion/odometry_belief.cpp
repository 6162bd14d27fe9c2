// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/odometry_belief.hpp"

#include <algorithm>
#include <cmath>

#include "core/motion/same_time.hpp"

namespace hidwa_local_planner {
namespace {

// Odometry agrees within these: what a base lags behind its ramp, noise and slip.
constexpr double kToleranceX = 0.2;      // [m/s]
constexpr double kToleranceTheta = 0.5;  // [rad/s]

// From `before` to `after` [unit/s] within `time` [s]: as fast as the limits allow, and the tolerance.
bool follows(double after, double before, double time, double tolerance, const AxisLimits& axis) {
  return std::abs(after - before) <= tolerance + std::max(axis.acc, axis.braking) * std::max(time, 0.0);
}

bool is_explained(double measured, const Interval& explained, double tolerance) {
  return measured >= explained.lo - tolerance && measured <= explained.hi + tolerance;
}

// Or it goes the other way.
bool faster_than_explained(double measured, const Interval& explained, double tolerance) {
  return measured < std::min(explained.lo, 0.0) - tolerance || measured > std::max(explained.hi, 0.0) + tolerance;
}

}  // namespace

Twist2 reading_tolerance(const Parameters& p, const Twist2& last) {
  // Inside the motors' dead band the robot does not move yet although the command grows: such a reading agrees.
  const double omega = std::abs(last.omega);
  const double standing = omega <= p.min_in_place_vel_theta ? omega : 0.0;
  return {kToleranceX, kToleranceTheta + standing};
}

OdometryReading AxisBelief::judge(double now, double heard, double measured, const Interval& explained,
                                  double tolerance, const AxisLimits& axis) {
  if (is_explained(measured, explained, tolerance)) {
    forget();
    return OdometryReading::agrees;
  }
  if (!faster_than_explained(measured, explained, tolerance)) {
    return note_slow(heard, measured, tolerance, axis) ? OdometryReading::slower : OdometryReading::maybe_slower;
  }
  slow_ = 0;
  if (!fast_ || now < since_ || !follows(measured, last_, now - last_time_, tolerance, axis)) since_ = now;
  const bool known = sure_ && now >= believed_time_ && now - believed_time_ <= kLongEnough + kSameTime;
  const bool goes_on = known && follows(measured, believed_, now - believed_time_, tolerance, axis);
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

// True where it is believed.
bool AxisBelief::note_slow(double heard, double measured, double tolerance, const AxisLimits& axis) {
  if (slow_ > 0 && heard == last_time_) return slow_ >= kEnough;
  const bool goes_on = slow_ > 0 && follows(measured, last_, heard - last_time_, tolerance, axis);
  const int slow = goes_on ? std::min(slow_ + 1, kEnough) : 1;
  forget();
  slow_ = slow;
  last_ = measured;
  last_time_ = heard;
  return slow_ >= kEnough;
}

double AxisBelief::believed(double measured, const Interval& explained, double tolerance, double last) const {
  if (faster_than_explained(measured, explained, tolerance)) return sure_ ? believed_ : last;
  return is_explained(measured, explained, tolerance) || slow_ >= kEnough ? measured : last;
}

}  // namespace hidwa_local_planner
