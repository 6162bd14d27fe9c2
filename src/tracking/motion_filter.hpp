// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// A Kalman filter of constant velocity, disturbed by white acceleration (Bar-Shalom, Li, Kirubarajan: Estimation with
/// Applications to Tracking and Navigation, 2001, section 6.2).
class MotionFilter {
 public:
  MotionFilter() = default;

  /// At rest at `position`, with its covariance [m^2] and the deviation of the velocity [m/s].
  MotionFilter(const Point& position, const Eigen::Matrix2d& covariance, double speed_deviation, double time);

  /// To a later time [s]; `density` is that of the acceleration [m^2/s^3]. An earlier time changes nothing.
  void predict(double time, double density);

  /// Takes a position with its covariance [m^2]. Returns the square of the innovation over its variance: chi-squared
  /// with two degrees of freedom.
  double correct(const Point& position, const Eigen::Matrix2d& covariance);

  /// What correct() would return.
  double mismatch(const Point& position, const Eigen::Matrix2d& covariance) const;

  const Point& position() const { return p_; }
  const Point& velocity() const { return v_; }
  double position_deviation() const;  // along the worst axis [m]
  double velocity_deviation() const;  // likewise [m/s]
  double time() const { return time_; }

 private:
  friend class ManoeuvreFilter;

  Point p_{0.0, 0.0};
  Point v_{0.0, 0.0};
  Eigen::Matrix2d pp_ = Eigen::Matrix2d::Zero();  // covariance of the position
  Eigen::Matrix2d pv_ = Eigen::Matrix2d::Zero();  // of position (rows) and velocity (columns)
  Eigen::Matrix2d vv_ = Eigen::Matrix2d::Zero();  // of the velocity
  double time_ = 0.0;
};

/// Interacting multiple models (ibidem, section 11.6.6): who walks on, who walks as people do, and who leaps to another
/// velocity. So a steady velocity is known well, and a new one within a few readings.
class ManoeuvreFilter {
 public:
  ManoeuvreFilter() = default;

  /// As MotionFilter; `acceleration` is the usual one of a mover [m/s^2].
  ManoeuvreFilter(const Point& position, const Eigen::Matrix2d& covariance, double speed_deviation, double time,
                  double acceleration);

  /// The usual acceleration from now on [m/s^2].
  void expect(double acceleration);

  /// To a later time [s]. An earlier time changes nothing.
  void predict(double time);

  /// Takes a position with its covariance [m^2]. Returns mismatch() as it was before.
  double correct(const Point& position, const Eigen::Matrix2d& covariance);

  /// The square of the innovation over its variance.
  double mismatch(const Point& position, const Eigen::Matrix2d& covariance) const {
    return mixture_.mismatch(position, covariance);
  }

  /// The mixture's mean and spread.
  const Point& position() const { return mixture_.position(); }
  const Point& velocity() const { return mixture_.velocity(); }
  double position_deviation() const { return mixture_.position_deviation(); }
  double velocity_deviation() const { return mixture_.velocity_deviation(); }
  double time() const { return mixture_.time(); }

 private:
  static constexpr std::size_t kModels = 3;
  using Weights = std::array<double, kModels>;

  void mix(double elapsed);
  static MotionFilter merged(const std::array<MotionFilter, kModels>& models, const Weights& weights);

  std::array<MotionFilter, kModels> models_;
  Weights weights_{};      // probabilities of the models
  Weights densities_{};    // of the acceleration [m^2/s^3]
  double leap_end_ = 0.0;  // how often a leap ends in each of the other models [1/s]
  MotionFilter mixture_;
};

}  // namespace tracking
}  // namespace hidwa_local_planner
