// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// A Kalman filter of constant velocity, disturbed by white acceleration (Bar-Shalom, Li, Kirubarajan: Estimation with
/// Applications to Tracking and Navigation, 2001, section 6.2). Both axes have the same noise, hence one covariance.
class MotionFilter {
 public:
  MotionFilter() = default;

  /// At rest at `position`, with deviations of position [m] and velocity [m/s].
  MotionFilter(const Point& position, double deviation, double speed_deviation, double time);

  /// To a later time [s]; `density` is that of the acceleration [m^2/s^3]. An earlier time changes nothing.
  void predict(double time, double density);

  /// Takes a position with its deviation [m]. Returns the square of the innovation over its variance: chi-squared with
  /// two degrees of freedom.
  double correct(const Point& position, double deviation);

  /// What correct() would return.
  double mismatch(const Point& position, double deviation) const;

  /// The velocity is less certain than the filter knows: its variance grows by the square of `deviation` [m/s].
  void doubt_velocity(double deviation) { vv_ += deviation * deviation; }

  const Point& position() const { return p_; }
  const Point& velocity() const { return v_; }
  double position_deviation() const;  // [m]
  double velocity_deviation() const;  // [m/s]
  double time() const { return time_; }

 private:
  Point p_{0.0, 0.0};
  Point v_{0.0, 0.0};
  double pp_ = 0.0;  // variance of the position along an axis
  double pv_ = 0.0;  // its covariance with the velocity
  double vv_ = 0.0;  // variance of the velocity
  double time_ = 0.0;
};

}  // namespace tracking
}  // namespace hidwa_local_planner
