// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Totals, velocities [m/s, rad/s] and times [s] of candidates that differ by no more than this are equal.
constexpr double kEqual = 1e-9;

/// Decides between candidates of equal totals.
class TieRule {
 public:
  TieRule(const Parameters& parameters, const Twist2& last_command);
  /// True when `a` is to be preferred to `b`. With `method: hidwa` the smallest change from the last command, as the
  /// time that the acceleration limits need for it, then the smaller |omega|, then the side of the last turn, then
  /// left. With `method: paper`: the lowest v, then the most negative omega.
  bool prefers(const Twist2& a, const Twist2& b) const;

 private:
  double change(const Twist2& u) const;  // [s]

  bool first_;
  Twist2 last_;
  double acc_x_, acc_theta_;
};

}  // namespace hidwa_local_planner
