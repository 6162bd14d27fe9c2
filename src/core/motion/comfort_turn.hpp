// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner {

/// How gently autonomy changes its turn: evenly over `time`, and no faster than `acc`. Rollouts, the dynamic window and
/// commands go by it alike, so that what is scored and checked is what is driven. Coming to rest is not bound by it.
struct ComfortTurn {
  double acc = 0.0;   // [rad/s^2]; 0: not bound, the limits alone hold
  double time = 0.0;  // [s]

  static ComfortTurn from(const Parameters& p) {
    return p.turns_gently() ? ComfortTurn{p.comfort_acc_lim_theta, p.comfort_turn_time} : ComfortTurn{};
  }

  bool binds() const { return acc > 0.0; }
  /// The limits within which the turn goes from `from` towards that of a sample, `target` [rad/s].
  AxisLimits towards(const AxisLimits& axis, double from, double target) const {
    if (!binds()) return axis;
    return within(axis, time > 0.0 ? std::min(acc, std::abs(target - from) / time) : acc);
  }
  /// The limits of every such turn.
  AxisLimits widest(const AxisLimits& axis) const { return binds() ? within(axis, acc) : axis; }

 private:
  static AxisLimits within(AxisLimits axis, double most) {
    axis.acc = std::min(axis.acc, most);
    axis.braking = std::min(axis.braking, most);
    return axis;
  }
};

}  // namespace hidwa_local_planner
