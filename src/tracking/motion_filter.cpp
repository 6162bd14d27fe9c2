// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/motion_filter.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr double kAccelerationTime = 0.2;  // for which an acceleration lasts [s]
constexpr double kSteadyShare = 0.2;       // of the usual acceleration, while somebody walks on
constexpr double kLeapDensity = 10.0;      // a leap of 1 m/s (deviation) within 0.1 s [m^2/s^3]

// How often the model of who walks on, and that of who walks as people do, give way to another (column) [1/s].
constexpr std::array<double, 3> kRates[] = {{0.0, 0.1, 0.02}, {2.0, 0.0, 0.05}};

// A leap gives way to each of them the sooner, the better the readings tell the new velocity. While it may go on,
// nothing is known of the velocity.
constexpr double kLeapKnown = 0.3;                       // deviation of a reading times that rate [m/s]
constexpr double kSlowestEnd = 5.0, kFastestEnd = 40.0;  // [1/s]

Eigen::Matrix2d isotropic(double deviation) { return deviation * deviation * Eigen::Matrix2d::Identity(); }

// Square root of the larger eigenvalue.
double worst_deviation(const Eigen::Matrix2d& c) {
  const double mean = 0.5 * (c(0, 0) + c(1, 1));
  return std::sqrt(std::max(0.0, mean + std::hypot(0.5 * (c(0, 0) - c(1, 1)), c(0, 1))));
}

}  // namespace

MotionFilter::MotionFilter(const Point& position, const Eigen::Matrix2d& covariance, double speed_deviation,
                           double time)
    : p_(position), pp_(covariance), vv_(isotropic(speed_deviation)), time_(time) {}

void MotionFilter::predict(double time, double density) {
  const double dt = time - time_;
  if (!(dt > 0.0)) return;
  const Eigen::Matrix2d noise = density * dt * Eigen::Matrix2d::Identity();
  p_ += dt * v_;
  pp_ += dt * (pv_ + pv_.transpose()) + dt * dt * (vv_ + noise / 3.0);
  pv_ += dt * (vv_ + noise / 2.0);
  vv_ += noise;
  time_ = time;
}

double MotionFilter::mismatch(const Point& position, const Eigen::Matrix2d& covariance) const {
  const Point innovation = position - p_;
  const Eigen::Matrix2d s = pp_ + covariance;
  return innovation.dot(s.inverse() * innovation);
}

double MotionFilter::correct(const Point& position, const Eigen::Matrix2d& covariance) {
  const Point innovation = position - p_;
  const Eigen::Matrix2d inverse = Eigen::Matrix2d(pp_ + covariance).inverse();
  const Eigen::Matrix2d gain_p = pp_ * inverse;
  const Eigen::Matrix2d gain_v = pv_.transpose() * inverse;
  p_ += gain_p * innovation;
  v_ += gain_v * innovation;
  vv_ -= Eigen::Matrix2d(gain_v * pv_);
  pv_ -= Eigen::Matrix2d(gain_p * pv_);
  pp_ -= Eigen::Matrix2d(gain_p * pp_);
  pp_ = Eigen::Matrix2d(0.5 * (pp_ + pp_.transpose()));
  vv_ = Eigen::Matrix2d(0.5 * (vv_ + vv_.transpose()));
  return innovation.dot(inverse * innovation);
}

double MotionFilter::position_deviation() const { return worst_deviation(pp_); }
double MotionFilter::velocity_deviation() const { return worst_deviation(vv_); }

ManoeuvreFilter::ManoeuvreFilter(const Point& position, const Eigen::Matrix2d& covariance, double speed_deviation,
                                 double time, double acceleration)
    : weights_{0.5, 0.5, 0.0}, leap_end_(kSlowestEnd), mixture_(position, covariance, speed_deviation, time) {
  expect(acceleration);
  models_.fill(mixture_);
}

void ManoeuvreFilter::expect(double acceleration) {
  const double density = acceleration * acceleration * kAccelerationTime;
  densities_ = {kSteadyShare * kSteadyShare * density, density, std::max(kLeapDensity, density)};
}

MotionFilter ManoeuvreFilter::merged(const std::array<MotionFilter, kModels>& models, const Weights& weights) {
  MotionFilter m = models[0];
  m.p_ = m.v_ = Point(0.0, 0.0);
  m.pp_ = m.pv_ = m.vv_ = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < kModels; ++i) {
    m.p_ += weights[i] * models[i].p_;
    m.v_ += weights[i] * models[i].v_;
  }
  for (std::size_t i = 0; i < kModels; ++i) {
    const Point dp = models[i].p_ - m.p_, dv = models[i].v_ - m.v_;
    m.pp_ += weights[i] * (models[i].pp_ + dp * dp.transpose());
    m.pv_ += weights[i] * (models[i].pv_ + dp * dv.transpose());
    m.vv_ += weights[i] * (models[i].vv_ + dv * dv.transpose());
  }
  return m;
}

// Each model goes on from what those say that it may have taken over from.
void ManoeuvreFilter::mix(double elapsed) {
  std::array<Weights, kModels> from;  // probability of having been j, if it is i now
  Weights now{};
  for (std::size_t j = 0; j < kModels; ++j) {
    const Weights rates = j < 2 ? kRates[j] : Weights{leap_end_, leap_end_, 0.0};
    const double leaves = rates[0] + rates[1] + rates[2];
    const double left = 1.0 - std::exp(-leaves * elapsed);
    for (std::size_t i = 0; i < kModels; ++i) {
      const double change = i == j ? 1.0 - left : left * rates[i] / leaves;
      from[i][j] = change * weights_[j];
      now[i] += from[i][j];
    }
  }
  const std::array<MotionFilter, kModels> before = models_;
  for (std::size_t i = 0; i < kModels; ++i) {
    if (!(now[i] > 0.0)) continue;
    for (double& share : from[i]) share /= now[i];
    models_[i] = merged(before, from[i]);
  }
  weights_ = now;
}

void ManoeuvreFilter::predict(double time) {
  const double elapsed = time - mixture_.time();
  if (!(elapsed > 0.0)) return;
  mix(elapsed);
  for (std::size_t i = 0; i < kModels; ++i) models_[i].predict(time, densities_[i]);
  mixture_ = merged(models_, weights_);
}

double ManoeuvreFilter::correct(const Point& position, const Eigen::Matrix2d& covariance) {
  const double mismatched = mismatch(position, covariance);
  Weights exponents{}, widths{};
  for (std::size_t i = 0; i < kModels; ++i) {
    widths[i] = std::sqrt(Eigen::Matrix2d(models_[i].pp_ + covariance).determinant());
    exponents[i] = -0.5 * models_[i].correct(position, covariance);
  }
  const double most = *std::max_element(exponents.begin(), exponents.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < kModels; ++i) {
    weights_[i] *= std::exp(exponents[i] - most) / widths[i];
    sum += weights_[i];
  }
  for (double& weight : weights_) weight /= sum;
  mixture_ = merged(models_, weights_);
  leap_end_ = std::min(std::max(kLeapKnown / worst_deviation(covariance), kSlowestEnd), kFastestEnd);
  return mismatched;
}

}  // namespace tracking
}  // namespace hidwa_local_planner
