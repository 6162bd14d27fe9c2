// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// One axis on its way from a velocity to a commanded one. A base may get there at once at its limit and then keep the
/// velocity, or evenly over one control period, or in any way between these two. at() is the way that gets farthest: at
/// the limit where it speeds up, evenly where it slows down; evenly too where the direction changes. Where the axis
/// `lags`, it is the other one. A change that takes longer than a period is made at the limit.
class AxisRamp {
 public:
  AxisRamp(const AxisLimits& axis, double from, double to, double period, bool lags = false)
      : axis_(axis), from_(from), to_(to), period_(period) {
    const bool turns_round = from * to < 0.0;
    const bool speeds_up = !turns_round && std::abs(to) > std::abs(from);
    const double through_zero = std::abs(from) / axis.braking;
    needed_ = turns_round ? through_zero + std::abs(to) / axis.acc
                          : std::abs(to - from) / (speeds_up ? axis.acc : axis.braking);
    free_ = needed_ < period + kRounding;
    const bool at_limit = !free_ || speeds_up != lags;
    reached_ = at_limit ? needed_ : period;
    corner_ = turns_round && at_limit ? through_zero : reached_;
  }

  /// The velocity after `t` [s].
  double at(double t) const {
    if (t >= reached_ - kRounding) return to_;
    if (corner_ == reached_) return from_ + t / reached_ * (to_ - from_);
    return t < corner_ ? from_ * (1.0 - t / corner_) : to_ * (t - corner_) / (reached_ - corner_);
  }
  /// Times between which it changes evenly [s]: the change of direction, and when the command is reached.
  double corner() const { return corner_; }
  double reached() const { return reached_; }

  /// How far apart two ways can get until `t` [s], at most: the integral of the difference of their velocities
  /// [unit], what follows from a command that is cut short by the next one included.
  double spread(double t) const {
    if (!free_ || t <= 0.0) return 0.0;
    const double corner = from_ * to_ < 0.0 ? std::abs(from_) / axis_.braking : needed_;
    const double knots[] = {std::min(corner, t), std::min(needed_, t), std::min(period_, t)};
    double area = 0.0, before = 0.0, last = 0.0;
    for (const double knot : knots) {
      const double apart = between(knot);
      area += 0.5 * (before + apart) * (knot - last);
      before = apart;
      last = knot;
    }
    // Cut short: until the next command is reached the two stay so far apart, and then close at the limit.
    return area + 1.5 * before * period_;
  }

 private:
  static constexpr double kRounding = 1e-9;  // [s]
  // Between the two ways at the ends of what is possible.
  double between(double t) const {
    if (t >= period_ - kRounding) return 0.0;
    return std::abs(axis_.ramp(from_, to_, t) - (from_ + t / period_ * (to_ - from_)));
  }

  AxisLimits axis_;
  double from_ = 0.0, to_ = 0.0;  // [unit/s]
  double period_ = 0.0;           // [s]
  double needed_ = 0.0;           // at the limit [s]
  double corner_ = 0.0, reached_ = 0.0;
  bool free_ = false;  // there is more than one way
};

/// Which axes of a base lag.
struct Lag {
  bool v = false, omega = false;
  bool any() const { return v || omega; }
};

/// Those ways of a base besides the one that gets farthest on both axes.
inline constexpr std::array<Lag, 3> kLags{{{true, false}, {false, true}, {true, true}}};

/// Both axes on their way to a command, each on its own.
class CommandRamp {
 public:
  CommandRamp(const VelocityLimits& limits, const Twist2& from, const Twist2& to, double period, const Lag& lag = {})
      : v_(limits.x, from.v, to.v, period, lag.v),
        omega_(limits.theta, from.omega, to.omega, period, lag.omega),
        lags_(lag.any()) {}

  Twist2 at(double t) const { return {v_.at(t), omega_.at(t)}; }
  /// [m, rad]; none where it lags: all else is rolled out then.
  Twist2 spread(double t) const { return lags_ ? Twist2{} : Twist2{v_.spread(t), omega_.spread(t)}; }
  /// Until when both change evenly, in order, none later than `end` [s], which is the last.
  std::array<double, 5> corners(double end) const {
    std::array<double, 5> all{std::min(v_.corner(), end), std::min(v_.reached(), end), std::min(omega_.corner(), end),
                              std::min(omega_.reached(), end), end};
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  AxisRamp v_, omega_;
  bool lags_;
};

}  // namespace hidwa_local_planner
