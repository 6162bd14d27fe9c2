// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hidwa_local_planner {

/// Measures for how long a condition has held without a break.
class ConditionTimer {
 public:
  /// The condition at `now` [s]. When time goes back, the measurement starts again.
  void observe(double now, bool holds) {
    if (holds && (!holds_ || now < since_)) since_ = now;
    holds_ = holds;
  }
  void reset() { holds_ = false; }
  bool holds() const { return holds_; }
  /// [s]; 0 where it does not hold.
  double time(double now) const { return holds_ ? now - since_ : 0.0; }
  /// Whether it holds, and has for `duration` [s] or longer.
  bool for_at_least(double duration, double now) const { return holds_ && now - since_ >= duration; }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.holds_, self.since_);
  }

 private:
  bool holds_ = false;
  double since_ = 0.0;  // [s]
};

}  // namespace hidwa_local_planner
