// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/samples.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

// A robot slower than this counts as turning on the spot: the motors' dead band for that applies [m/s].
constexpr double kInPlace = 0.01;

bool in_dead_band(const Parameters& p, const Twist2& u) {
  return std::abs(u.v) < kInPlace && u.omega != 0.0 && std::abs(u.omega) < p.min_in_place_vel_theta;
}

// What drives is at least as fast as min_vel_x, or as the window allows that begins below it.
double slowest(const Parameters& p, const DynamicWindow& window) { return std::min(p.min_vel_x, window.v.hi); }

bool is_zero(const Twist2& u) { return u.v == 0.0 && u.omega == 0.0; }

double into(const Interval& interval, double value) { return std::min(std::max(value, interval.lo), interval.hi); }

}  // namespace

DynamicWindow dynamic_window(const Parameters& p, const VelocityLimits& limits, const Twist2& reference,
                             double period) {
  const double dt = p.generator == Generator::standard ? std::max(p.sim_time, period) : period;
  return {reachable(limits.x, reference.v, dt), reachable(limits.theta, reference.omega, dt)};
}

void spread(const Interval& interval, int count, std::vector<double>& values) {
  values.clear();
  if (interval.hi <= interval.lo || count < 2) {
    values.push_back(interval.lo);
    return;
  }
  const int last = count - 1;
  bool zero_due = interval.lo < 0.0 && interval.hi > 0.0;
  for (int i = 0; i <= last; ++i) {
    const double value = i == 0      ? interval.lo
                         : i == last ? interval.hi
                                     : (interval.lo * (last - i) + interval.hi * i) / last;
    if (zero_due && value > 0.0) values.push_back(0.0);
    if (value >= 0.0) zero_due = false;
    values.push_back(value);
  }
}

Twist2 into_window(const Parameters& p, const VelocityLimits& limits, const DynamicWindow& window,
                   const Twist2& velocity) {
  Twist2 u = limits.clamp({into(window.v, velocity.v), into(window.omega, velocity.omega)});
  if (const double least = slowest(p, window); u.v > 0.0 && u.v < least) {
    u.v = u.v < 0.5 * least ? 0.0 : least;
    u = limits.clamp(u);
  }
  if (!in_dead_band(p, u)) return u;
  const double band = p.min_in_place_vel_theta;
  u.omega = std::abs(u.omega) < 0.5 * band ? 0.0 : std::copysign(band, u.omega);
  u = limits.clamp(u);  // a turn raised to the band's edge may be too much for the wheels, or too fast
  if (in_dead_band(p, u)) u.omega = 0.0;
  return u;
}

void Sampler::make(const Parameters& p, const VelocityLimits& limits, const CycleStart& start,
                   const SampleRequest& request) {
  window_ = dynamic_window(p, limits, start.reference, start.period);
  spread(window_.v, request.vx_samples, v_);
  spread(window_.omega, request.vth_samples, omega_);
  if (request.creep > 0.0) {
    add_speed(request.creep);
    add_speed(-request.creep);
  }
  const std::size_t most = (v_.size() + 1) * (omega_.size() + 1) + 8;
  if (samples_.capacity() < most) samples_.reserve(most + most / 8);
  add_grid(p, limits);
  add_extra(p, limits, request);
}

void Sampler::add_speed(double v) {
  const auto at = std::lower_bound(v_.begin(), v_.end(), v);
  if (v > window_.v.lo && v < window_.v.hi && *at != v) v_.insert(at, v);
}

void Sampler::add_grid(const Parameters& p, const VelocityLimits& limits) {
  const bool wheels = limits.wheel_speed > 0.0;
  const double least = slowest(p, window_);
  samples_.resize(v_.size() * omega_.size());
  std::size_t count = 0;
  for (const double omega : omega_) {
    for (const double v : v_) {
      const Twist2 u{v, omega};
      if (is_zero(u) || in_dead_band(p, u) || (v > 0.0 && v < least) || (wheels && !limits.wheels_allow(u))) continue;
      samples_[count++] = {u, SampleKind::grid};
    }
  }
  samples_.resize(count);
  // A window narrower than the dead band would leave no turn on the spot at all: its edges are always tried.
  const double edge = p.min_in_place_vel_theta;
  if (edge <= 0.0 || window_.v.lo > 0.0 || window_.v.hi < 0.0) return;
  for (const double omega : {-edge, edge}) {
    if (limits.wheels_allow({0.0, omega})) samples_.push_back({{0.0, omega}, SampleKind::grid});
  }
}

void Sampler::add_extra(const Parameters& p, const VelocityLimits& limits, const SampleRequest& request) {
  const bool own = p.method == Method::hidwa;
  if (own || p.admissibility == Admissibility::braking) samples_.push_back({{}, SampleKind::brake});
  if (own && request.operator_command != nullptr) {
    samples_.push_back({into_window(p, limits, window_, *request.operator_command), SampleKind::operator_command});
  }
  if (own && request.blended != nullptr) {
    samples_.push_back({into_window(p, limits, window_, *request.blended), SampleKind::blended});
  }
  if (own) {
    const Twist2 u = into_window(p, limits, window_, request.previous);
    if (!is_zero(u)) samples_.push_back({u, SampleKind::previous});
  }
}

}  // namespace hidwa_local_planner
