// SPDX-License-Identifier: BSD-3-Clause
// What commands that take effect one after the other make of the velocity of a base that keeps its limits, by searching
// them for every time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "support/naive_ramp.hpp"

namespace hidwa_local_planner::test {

/// A command and when it takes effect, counted from now [s].
struct NaiveEffect {
  double time = 0.0;
  Twist2 command;
};

inline NaiveAxis naive_axis_x(const Parameters& p, double period) { return {p.acc_lim_x, p.braking_x(), period}; }
inline NaiveAxis naive_axis_theta(const Parameters& p, double period) {
  return {p.acc_lim_theta, p.braking_theta(), period};
}

/// Axes that do not get as far as they might.
struct NaiveLag {
  bool v = false, omega = false;
  bool any() const { return v || omega; }
};

/// Those besides the one that gets farthest on both.
inline std::vector<NaiveLag> naive_lags() { return {{true, false}, {false, true}, {true, true}}; }

class NaiveEffects {
 public:
  /// Each command is reached within `period` [s], or as fast as the limits allow, unless the next one takes effect
  /// before. `before` is the velocity when the first one does.
  NaiveEffects(const Parameters& p, double period, const Twist2& before, std::vector<NaiveEffect> effects)
      : x_(naive_axis_x(p, period)),
        theta_(naive_axis_theta(p, period)),
        before_(before),
        effects_(std::move(effects)) {}
  /// One velocity for ever.
  NaiveEffects(const Parameters& p, double period, const Twist2& u) : NaiveEffects(p, period, u, {{0.0, u}}) {}

  NaiveEffects then(double time, const Twist2& command) const {
    NaiveEffects more = *this;
    more.effects_.push_back({time, command});
    return more;
  }

  /// The same from number `first` on, by a base that lags.
  NaiveEffects lagging(std::size_t first, const NaiveLag& lag) const {
    NaiveEffects other = *this;
    other.before_ = from(first);
    other.effects_.erase(other.effects_.begin(), other.effects_.begin() + static_cast<std::ptrdiff_t>(first));
    other.lag_ = lag;
    return other;
  }
  const NaiveLag& lag() const { return lag_; }

  /// The same, were the latency shorter by so much [s].
  NaiveEffects sooner(double by) const {
    NaiveEffects quick = *this;
    for (NaiveEffect& effect : quick.effects_) effect.time -= by;
    return quick;
  }

  const std::vector<NaiveEffect>& list() const { return effects_; }
  const NaiveAxis& x() const { return x_; }
  const NaiveAxis& theta() const { return theta_; }

  /// The velocity when number i takes effect: as far as the one before it had come by then.
  Twist2 from(std::size_t i) const {
    if (i == 0) return before_;
    return after(i - 1, effects_[i].time - effects_[i - 1].time);
  }
  Twist2 velocity(double t) const {
    if (effects_.empty() || t < effects_[0].time) return before_;
    std::size_t i = 0;
    while (i + 1 < effects_.size() && effects_[i + 1].time <= t) ++i;
    return after(i, t - effects_[i].time);
  }

 private:
  // The velocity `t` after number i took effect.
  Twist2 after(std::size_t i, double t) const {
    const Twist2 a = from(i), b = effects_[i].command;
    return {lag_.v ? naive_lagging(x_, a.v, b.v, t) : naive_farthest(x_, a.v, b.v, t),
            lag_.omega ? naive_lagging(theta_, a.omega, b.omega, t) : naive_farthest(theta_, a.omega, b.omega, t)};
  }

  NaiveAxis x_, theta_;
  Twist2 before_;
  std::vector<NaiveEffect> effects_;
  NaiveLag lag_;
};

}  // namespace hidwa_local_planner::test
