// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// How the robot goes on until a command that is sent now takes effect: from a velocity by legs, in each of which both
/// axes change evenly. Allocates nothing while it has no more than kMostLegs.
class UnderWay {
 public:
  static constexpr std::size_t kMostLegs = 768;  // three a command that may be under way

  struct Leg {
    Twist2 end;             // [m/s, rad/s]
    double duration = 0.0;  // [s]
  };

  UnderWay() { legs_.reserve(kMostLegs); }
  /// One velocity for `duration` [s].
  UnderWay(const Twist2& u, double duration) : UnderWay() { keep(u, duration); }

  void keep(const Twist2& u, double duration) {
    begin(u);
    add(u, duration);
  }
  void begin(const Twist2& u) {
    begin_ = u;
    legs_.clear();
  }
  void add(const Twist2& end, double duration) { legs_.push_back({end, duration}); }

  const Twist2& begin() const { return begin_; }
  const Twist2& end() const { return legs_.empty() ? begin_ : legs_.back().end; }
  const std::vector<Leg>& legs() const { return legs_; }

  /// The largest |v| [m/s].
  double fastest() const {
    double v = std::abs(begin_.v);
    for (const Leg& leg : legs_) v = std::max(v, std::abs(leg.end.v));
    return v;
  }
  /// How far the robot's centre gets, at most [m].
  double reach() const {
    double v = std::abs(begin_.v), way = 0.0;
    for (const Leg& leg : legs_) {
      way += std::max(v, std::abs(leg.end.v)) * leg.duration;
      v = std::abs(leg.end.v);
    }
    return way;
  }

 private:
  Twist2 begin_;
  std::vector<Leg> legs_;
};

}  // namespace hidwa_local_planner
