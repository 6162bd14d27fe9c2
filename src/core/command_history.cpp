// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/command_history.hpp"

#include <algorithm>
#include <cmath>

#include "hidwa_local_planner/core/command_ramp.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kSameTime = 1e-6;      // [s]; stamps are sums of periods
constexpr double kSameVelocity = 1e-6;  // [m/s, rad/s]; more than rounding, less than any actuator's step

bool in_reach(const AxisLimits& axis, double from, double to, double period) {
  return std::abs(to - from) <= std::max(axis.acc, axis.braking) * period + kSameVelocity;
}

// Makes legs of a velocity over time, given by its corners; time is counted from now.
class Player {
 public:
  Player(const Twist2& u, UnderWay& under_way) : u_(u), under_way_(under_way) { under_way_.begin(u); }

  // The velocity changes evenly to `u` at `time` [s], from the last corner on; before now it has done so already.
  void corner(double time, const Twist2& u) {
    if (time <= kSameTime) {
      at_ = std::min(time, 0.0);
      u_ = u;
      under_way_.begin(u);
      return;
    }
    if (at_ < 0.0) pass_now(time, u);
    if (!(u == u_)) {
      leg_to(at_, u_);
      leg_to(time, u);
    }
    at_ = time;
    u_ = u;
  }
  // What was even up to the end is one leg.
  void finish() { leg_to(at_, u_); }

 private:
  void pass_now(double time, const Twist2& u) {
    const double gone = -at_ / (time - at_);
    u_ = {u_.v + gone * (u.v - u_.v), u_.omega + gone * (u.omega - u_.omega)};
    at_ = 0.0;
    under_way_.begin(u_);
  }
  void leg_to(double time, const Twist2& u) {
    if (time - done_ <= kSameTime) return;
    under_way_.add(u, time - done_);
    done_ = time;
  }

  double at_ = 0.0, done_ = 0.0;  // [s]: the last corner, the end of the last leg
  Twist2 u_;
  UnderWay& under_way_;
};

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

void CommandHistory::play(const VelocityLimits& limits, double period, double latency, UnderWay& under_way) const {
  const double now = seen_.value_or(0.0);
  const auto effect = [&](std::size_t i) { return i < sent_.size() ? sent_[i].time + latency - now : latency; };
  Player player(sent_.empty() ? Twist2{} : sent_.front().command, under_way);
  for (std::size_t i = 1; i < sent_.size(); ++i) {
    const double begin = effect(i);
    const CommandRamp ramp(limits, sent_[i - 1].command, sent_[i].command, std::min(period, effect(i + 1) - begin));
    player.corner(begin, sent_[i - 1].command);
    for (const double corner : ramp.corners()) player.corner(begin + corner, ramp.at(corner));
  }
  player.corner(latency, last());
  player.finish();
}

bool goes_on(const Parameters& p, const Twist2& measured, const CommandHistory& commands) {
  if (p.velocity_reference == VelocityReference::odometry) return false;
  const Twist2 last = commands.last();
  // Inside the motors' dead band the robot stands while the command already grows: that is no disagreement.
  const double dead_band =
      std::abs(last.omega) <= std::max(p.min_in_place_vel_theta, p.min_vel_theta) ? std::abs(last.omega) : 0.0;
  return within(measured.v, commands.range(&Twist2::v), p.velocity_reference_tolerance_x) &&
         within(measured.omega, commands.range(&Twist2::omega), p.velocity_reference_tolerance_theta + dead_band);
}

Twist2 velocity_reference(const Parameters& p, const Twist2& measured, const CommandHistory& commands) {
  return goes_on(p, measured, commands) ? commands.last() : measured;
}

}  // namespace hidwa_local_planner
