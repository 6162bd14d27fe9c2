// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/command_history.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

constexpr double kSameTime = 1e-6;      // [s]; stamps are sums of periods
constexpr double kSameVelocity = 1e-6;  // [m/s, rad/s]; more than rounding, less than any actuator's step

bool in_reach(const AxisLimits& axis, double from, double to, double period) {
  return std::abs(to - from) <= std::max(axis.acc, axis.braking) * period + kSameVelocity;
}

bool within(double value, const Interval& interval, double tolerance) {
  return value >= interval.lo - tolerance && value <= interval.hi + tolerance;
}

}  // namespace

void CommandHistory::observe(double now, double period, double latency, const Twist2& command,
                             const VelocityLimits& limits) {
  if (!seen_ || !(now >= *seen_)) forget();  // also where a time is no number
  Sent newest{seen_.value_or(now), command};
  if (!sent_.empty() && now == *seen_) {
    newest.time = sent_.back().time;
    sent_.pop_back();
  }
  if (!sent_.empty()) {
    const Twist2& before = sent_.back().command;
    const bool followed = in_reach(limits.x, before.v, command.v, period) &&
                          in_reach(limits.theta, before.omega, command.omega, period);
    if (!followed) sent_.clear();
  }
  if (sent_.size() == kMost) sent_.erase(sent_.begin());
  sent_.push_back(newest);
  // A command is in force until the next one is sent.
  const double begin = now - latency - period + kSameTime;
  while (sent_.size() > 1 && sent_[1].time <= begin) sent_.erase(sent_.begin());
  seen_ = now;
}

void CommandHistory::forget() {
  sent_.clear();
  seen_.reset();
}

Interval CommandHistory::range(double Twist2::* axis) const {
  Interval all{last().*axis, last().*axis};
  for (const Sent& sent : sent_) {
    all.lo = std::min(all.lo, sent.command.*axis);
    all.hi = std::max(all.hi, sent.command.*axis);
  }
  return all;
}

Twist2 velocity_reference(const Parameters& p, const Twist2& measured, const CommandHistory& commands) {
  if (p.velocity_reference == VelocityReference::odometry) return measured;
  const Twist2 last = commands.last();
  // Inside the motors' dead band the robot stands while the command already grows: that is no disagreement.
  const double dead_band =
      std::abs(last.omega) <= std::max(p.min_in_place_vel_theta, p.min_vel_theta) ? std::abs(last.omega) : 0.0;
  const bool agrees =
      within(measured.v, commands.range(&Twist2::v), p.velocity_reference_tolerance_x) &&
      within(measured.omega, commands.range(&Twist2::omega), p.velocity_reference_tolerance_theta + dead_band);
  return agrees ? last : measured;
}

}  // namespace hidwa_local_planner
