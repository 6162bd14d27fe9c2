// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/velocity_limits.hpp"

#include <algorithm>
#include <cmath>

#include "hidwa_local_planner/core/rest.hpp"

namespace hidwa_local_planner {

double AxisLimits::clamp(double velocity) const { return std::min(std::max(velocity, min), max); }

double AxisLimits::start_from(double velocity, double last_command) const {
  return std::min(std::max(velocity, std::min({min, last_command, 0.0})), std::max({max, last_command, 0.0}));
}

double AxisLimits::ramp(double velocity, double target, double dt) const {
  if (velocity == target) return target;
  const double direction = target > velocity ? 1.0 : -1.0;
  double left = dt;
  double u = velocity;
  if (u * direction < 0.0) {  // towards 0 first, and through it only if the target lies beyond
    const double stop = target * direction > 0.0 ? 0.0 : target;
    const double needed = std::abs(u - stop) / braking;
    if (needed > left) return u + direction * braking * left;
    u = stop;
    left -= needed;
    if (stop != 0.0 || target == 0.0) return target;
  }
  const double moved = u + direction * acc * left;
  return direction > 0.0 ? std::min(moved, target) : std::max(moved, target);
}

double AxisLimits::time_to_rest(double velocity) const { return std::abs(velocity) / braking; }

double AxisLimits::distance_to_rest(double velocity) const { return 0.5 * velocity * velocity / braking; }

Interval reachable(const AxisLimits& axis, double velocity, double dt) {
  // Beyond every limit, so that only the accelerations bind.
  const double far = std::abs(velocity) + (axis.acc + axis.braking) * dt + 1.0;
  const Interval all{axis.ramp(velocity, -far, dt), axis.ramp(velocity, far, dt)};
  if (all.lo > axis.max) return {all.lo, all.lo};
  if (all.hi < axis.min) return {all.hi, all.hi};
  return {std::max(all.lo, axis.min), std::min(all.hi, axis.max)};
}

VelocityLimits VelocityLimits::from(const Parameters& p) {
  VelocityLimits limits;
  limits.x = {std::min(p.min_vel_x, 0.0), p.max_vel_x, p.acc_lim_x, p.braking_x()};
  limits.theta = {-p.max_vel_theta, p.max_vel_theta, p.acc_lim_theta, p.braking_theta()};
  if (p.has_wheel_limit()) {
    limits.half_separation = 0.5 * p.wheel_separation;
    limits.wheel_speed = p.max_wheel_speed;
  }
  return limits;
}

bool VelocityLimits::wheels_allow(const Twist2& u) const {
  if (wheel_speed <= 0.0) return true;
  return std::abs(u.v) + std::abs(u.omega) * half_separation <= wheel_speed + kCommandRounding;
}

Twist2 VelocityLimits::clamp(const Twist2& velocity) const {
  Twist2 u{x.clamp(velocity.v), theta.clamp(velocity.omega)};
  if (wheels_allow(u)) return u;
  const double largest_omega = wheel_speed / half_separation;
  u.omega = std::min(std::max(u.omega, -largest_omega), largest_omega);
  const double left = std::max(0.0, wheel_speed - std::abs(u.omega) * half_separation);
  u.v = std::min(std::max(u.v, -left), left);
  return u;
}

Twist2 VelocityLimits::step(const Twist2& reference, const Twist2& target, double dt) const {
  Twist2 u{x.ramp(reference.v, target.v, dt), theta.ramp(reference.omega, target.omega, dt)};
  if (wheels_allow(u)) return u;
  // Keeps omega and slows v down as far as this period allows. If the wheels are still too fast, slows the turn, too.
  const double slowest = x.ramp(reference.v, 0.0, dt);
  const double left = std::max(0.0, wheel_speed - std::abs(u.omega) * half_separation);
  const double slowed = std::min(std::max(u.v, -left), left);
  u.v = std::abs(slowed) < std::abs(slowest) ? slowest : slowed;
  if (wheels_allow(u)) return u;
  const double turn_left = std::max(0.0, (wheel_speed - std::abs(u.v)) / half_separation);
  const double straightest = theta.ramp(reference.omega, 0.0, dt);
  const double turn = std::min(std::max(u.omega, -turn_left), turn_left);
  u.omega = std::abs(turn) < std::abs(straightest) ? straightest : turn;
  return u;
}

}  // namespace hidwa_local_planner
