// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/motion_filter.hpp"

#include <cmath>

namespace hidwa_local_planner {
namespace tracking {

MotionFilter::MotionFilter(const Point& position, double deviation, double speed_deviation, double time)
    : p_(position), pp_(deviation * deviation), vv_(speed_deviation * speed_deviation), time_(time) {}

void MotionFilter::predict(double time, double density) {
  const double dt = time - time_;
  if (!(dt > 0.0)) return;
  p_ += dt * v_;
  pp_ += dt * (2.0 * pv_ + dt * vv_) + density * dt * dt * dt / 3.0;
  pv_ += dt * vv_ + density * dt * dt / 2.0;
  vv_ += density * dt;
  time_ = time;
}

double MotionFilter::mismatch(const Point& position, double deviation) const {
  return (position - p_).squaredNorm() / (pp_ + deviation * deviation);
}

double MotionFilter::correct(const Point& position, double deviation) {
  const double mismatched = mismatch(position, deviation);
  const double s = pp_ + deviation * deviation;
  const double gain_p = pp_ / s;
  const double gain_v = pv_ / s;
  const Point innovation = position - p_;
  p_ += gain_p * innovation;
  v_ += gain_v * innovation;
  vv_ -= gain_v * pv_;
  pv_ -= gain_p * pv_;
  pp_ -= gain_p * pp_;
  return mismatched;
}

double MotionFilter::position_deviation() const { return std::sqrt(pp_); }
double MotionFilter::velocity_deviation() const { return std::sqrt(vv_); }

}  // namespace tracking
}  // namespace hidwa_local_planner
