// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/motion/command_ramp.hpp"
#include "core/motion/same_time.hpp"
#include "hidwa_local_planner/core/rest.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Of each axis the larger one.
inline Twist2 larger_of(const Twist2& a, const Twist2& b) { return {std::max(a.v, b.v), std::max(a.omega, b.omega)}; }

/// Of a point `radius` [m] from the robot's centre, at most [m/s].
inline double speed_at(const Twist2& u, double radius) { return std::abs(u.v) + radius * std::abs(u.omega); }

/// The motion until a command that is sent now takes effect: commands that were sent before are still pending. It
/// begins with a velocity and has legs, in each of which both axes change evenly. Allocates nothing while it has at
/// most kMostLegs legs.
class PendingMotion {
 public:
  static constexpr std::size_t kMostLegs = 1536;  // five for each pending command, and some

  struct Leg {
    Twist2 end;             // [m/s, rad/s]
    double duration = 0.0;  // [s]
    Twist2 spread;  // how far apart the ways to a command get that is reached from this leg on, see AxisRamp [m, rad]
  };

  PendingMotion() { legs_.reserve(kMostLegs); }
  /// One velocity for `duration` [s].
  PendingMotion(const Twist2& u, double duration) : PendingMotion() { keep(u, duration); }

  void keep(const Twist2& u, double duration) {
    begin(u);
    add(u, duration);
  }
  void begin(const Twist2& u) {
    begin_ = u;
    legs_.clear();
    past_ = 0;
    lag_ = {};
  }
  void add(const Twist2& end, double duration, const Twist2& spread = {}) { legs_.push_back({end, duration, spread}); }
  /// The first `duration` [s] are over: a leg ends there, made by cutting one in two where there is none.
  void mark_past(double duration) {
    Twist2 from = begin_;
    double left = duration;
    for (past_ = 0; past_ < legs_.size() && left > kSameTime; ++past_) {
      const Leg leg = legs_[past_];
      if (leg.duration > left + kSameTime) {
        const double part = left / leg.duration;
        const Twist2 cut{from.v + part * (leg.end.v - from.v), from.omega + part * (leg.end.omega - from.omega)};
        legs_[past_] = {leg.end, leg.duration - left, {}};
        legs_.insert(legs_.begin() + static_cast<std::ptrdiff_t>(past_), Leg{cut, left, leg.spread});
      }
      left -= legs_[past_].duration;
      from = legs_[past_].end;
    }
  }
  /// It is how a base goes on that lags, now and until it rests.
  void set_lag(const Lag& lag) { lag_ = lag; }
  const Lag& lag() const { return lag_; }
  /// The number of legs that are over.
  std::size_t past() const { return past_; }
  /// One axis has this velocity all the time instead.
  void replace(double Twist2::*axis, double velocity) {
    begin_.*axis = velocity;
    for (Leg& leg : legs_) {
      leg.end.*axis = velocity;
      leg.spread.*axis = 0.0;
    }
  }

  /// No leg moves.
  bool rests() const {
    return commands_rest(begin_) &&
           std::all_of(legs_.begin(), legs_.end(), [](const Leg& leg) { return commands_rest(leg.end); });
  }
  const Twist2& begin() const { return begin_; }
  const Twist2& end() const { return legs_.empty() ? begin_ : legs_.back().end; }
  const std::vector<Leg>& legs() const { return legs_; }

  /// The largest |v| and the largest |omega| [m/s, rad/s].
  Twist2 fastest() const {
    Twist2 most{std::abs(begin_.v), std::abs(begin_.omega)};
    for (const Leg& leg : legs_) most = larger_of(most, {std::abs(leg.end.v), std::abs(leg.end.omega)});
    return most;
  }
  /// How far a point `radius` [m] from the robot's centre gets, at most [m].
  double reach(double radius = 0.0) const {
    double u = speed_at(begin_, radius), way = 0.0;
    for (const Leg& leg : legs_) {
      way += std::max(u, speed_at(leg.end, radius)) * leg.duration;
      u = speed_at(leg.end, radius);
    }
    return way;
  }
  /// Of all legs together [m, rad].
  Twist2 spread() const {
    Twist2 all;
    for (const Leg& leg : legs_) {
      all.v += leg.spread.v;
      all.omega += leg.spread.omega;
    }
    return all;
  }

 private:
  Twist2 begin_;
  std::vector<Leg> legs_;
  std::size_t past_ = 0;
  Lag lag_;
};

}  // namespace hidwa_local_planner
