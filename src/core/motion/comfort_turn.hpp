// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner {

/// How gently autonomy changes its turn: evenly over `time`, and no faster than `acc`. Rollouts, the dynamic window and
/// commands go by it alike, so that what is scored and checked is what is driven. Coming to rest is bound by it in the
/// last turn at the goal alone.
struct ComfortTurn {
  double acc = 0.0;   // [rad/s^2]; 0: not bound, the limits alone hold
  double time = 0.0;  // [s]
  bool rest = false;  // it comes to rest gently too

  static ComfortTurn from(const Parameters& p, bool rest = false) {
    return p.turns_gently() ? ComfortTurn{p.comfort_acc_lim_theta, p.comfort_turn_time, rest} : ComfortTurn{};
  }

  bool binds() const { return acc > 0.0; }
  /// The limits within which the turn goes from `from` towards that of a sample, `target` [rad/s]. A turn that is
  /// faster than the robot may turn is brought back as fast as it can be.
  AxisLimits towards(const AxisLimits& axis, double from, double target) const {
    return within(axis, from, time > 0.0 ? std::min(acc, std::abs(target - from) / time) : acc);
  }
  /// The limits within which it comes to rest.
  AxisLimits to_rest(const AxisLimits& axis, double from) const { return rest ? within(axis, from, acc) : axis; }
  /// The limits of every such turn.
  AxisLimits widest(const AxisLimits& axis, double from) const { return within(axis, from, acc); }

 private:
  AxisLimits within(AxisLimits axis, double from, double most) const {
    if (!binds() || from > axis.max || from < axis.min) return axis;
    axis.acc = std::min(axis.acc, most);
    axis.braking = std::min(axis.braking, most);
    return axis;
  }
};

}  // namespace hidwa_local_planner
