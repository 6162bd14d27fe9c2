// SPDX-License-Identifier: BSD-3-Clause
#include "sim/diff_drive.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hidwa_local_planner {
namespace sim {
namespace {

void require(bool good, const std::string& what) {
  if (!good) throw std::invalid_argument("robot limits: " + what);
}

double finite_or_zero(double value) { return std::isfinite(value) ? value : 0.0; }

double clamp_magnitude(double value, double limit) { return std::max(-limit, std::min(limit, value)); }

}  // namespace

void check(const DriveLimits& l) {
  require(l.max_vel_x > 0.0 && l.max_vel_theta > 0.0, "max_vel_x and max_vel_theta must be positive");
  require(l.acc_lim_x > 0.0 && l.acc_lim_theta > 0.0, "acc_lim_x and acc_lim_theta must be positive");
  require(l.decel_lim_x > 0.0 && l.decel_lim_theta > 0.0, "decel_lim_x and decel_lim_theta must be positive");
  require(l.max_wheel_speed >= 0.0, "max_wheel_speed must not be negative");
  require(l.max_wheel_speed == 0.0 || l.wheel_separation > 0.0, "max_wheel_speed needs a positive wheel_separation");
  require(l.latency >= 0.0 && l.command_timeout >= 0.0, "latency and command_timeout must not be negative");
}

Pose moved(const Pose& pose, const Motion& motion) {
  const double half = 0.5 * motion.angle;
  // The chord of an arc is its length times sin(half)/half; the series keeps that exact near zero.
  const double chord = motion.distance * (std::abs(half) < 1e-4 ? 1.0 - half * half / 6.0 : std::sin(half) / half);
  return {pose.x + chord * std::cos(pose.theta + half), pose.y + chord * std::sin(pose.theta + half),
          normalized(pose.theta + motion.angle)};
}

double ramp(double& speed, double target, double acceleration, double deceleration, double dt) {
  double integral = 0.0;
  while (dt > 0.0 && speed != target) {
    const bool reverses = speed * target < 0.0;
    const bool slows = reverses || std::abs(target) < std::abs(speed);
    const double until = reverses ? 0.0 : target;
    const double rate = slows ? deceleration : acceleration;
    const double time = std::abs(until - speed) / rate;
    const double next = time <= dt ? until : speed + std::copysign(rate * dt, until - speed);
    const double passed = std::min(time, dt);
    integral += 0.5 * (speed + next) * passed;
    speed = next;
    dt -= passed;
  }
  return integral + speed * dt;
}

DiffDrive::DiffDrive(const DriveLimits& limits) : limits_(limits) { check(limits); }

Velocity DiffDrive::limited(Velocity velocity) const {
  velocity.v = clamp_magnitude(finite_or_zero(velocity.v), limits_.max_vel_x);
  velocity.omega = clamp_magnitude(finite_or_zero(velocity.omega), limits_.max_vel_theta);
  if (limits_.max_wheel_speed > 0.0) {
    // Where a wheel would have to turn faster than it can, the base slows down on the same curve.
    const double fastest = std::abs(velocity.v) + 0.5 * limits_.wheel_separation * std::abs(velocity.omega);
    const double share = std::min(1.0, limits_.max_wheel_speed / std::max(fastest, 1e-9));
    velocity.v *= share;
    velocity.omega *= share;
  }
  return velocity;
}

void DiffDrive::command(const Velocity& velocity, double now) {
  pending_.push_back({now + limits_.latency, limited(velocity)});
}

void DiffDrive::take_effect(double now) {
  constexpr double kRounding = 1e-9;  // [s], times are sums of steps
  while (!pending_.empty() && pending_.front().effective <= now + kRounding) {
    target_ = pending_.front().velocity;
    last_effect_ = pending_.front().effective;
    pending_.pop_front();
  }
  if (limits_.command_timeout > 0.0 && now - last_effect_ > limits_.command_timeout) target_ = Velocity();
}

Motion DiffDrive::step(double now, double dt) {
  take_effect(now);
  Motion motion;
  motion.distance = ramp(velocity_.v, target_.v, limits_.acc_lim_x, limits_.decel_lim_x, dt);
  motion.angle = ramp(velocity_.omega, target_.omega, limits_.acc_lim_theta, limits_.decel_lim_theta, dt);
  return motion;
}

}  // namespace sim
}  // namespace hidwa_local_planner
