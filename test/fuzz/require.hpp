// SPDX-License-Identifier: BSD-3-Clause
// What must hold whatever the input: where it does not, the program ends as by a fault, and libFuzzer keeps the input.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::fuzz {

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: %s\n", what);
  std::abort();
}

/// `command` is finite and, where the command before it was, beyond no limit that the former was not beyond, whatever
/// odometry says (README, Safety).
inline void require_within_limits(const Twist2& command, const Twist2& last, const Parameters& p) {
  constexpr double kRounding = 1e-9;
  require(is_finite(command), "the command is not a number");
  if (!is_finite(last)) return;
  require(command.v <= std::max({p.max_vel_x, last.v, 0.0}) + kRounding, "the command is faster than max_vel_x");
  require(command.v >= std::min({p.min_vel_x, last.v, 0.0}) - kRounding, "the command is below min_vel_x");
  require(std::abs(command.omega) <= std::max(p.max_vel_theta, std::abs(last.omega)) + kRounding,
          "the command turns faster than max_vel_theta");
}

/// From the last command, or from `reference`, the velocity that the cycle started from, the command changes by no more
/// than the limits allow in `period` [s]. The paper's method without a check of braking sends the sample itself.
inline void require_within_accelerations(const Twist2& command, const Twist2& last, const Twist2& reference,
                                         const Parameters& p, double period) {
  if (p.method == Method::paper && p.admissibility == Admissibility::horizon) return;
  constexpr double kRounding = 1e-9;
  const auto change = [](double to, double a, double b) { return std::min(std::abs(to - a), std::abs(to - b)); };
  require(change(command.v, last.v, reference.v) <= std::max(p.acc_lim_x, p.braking_x()) * period + kRounding,
          "the command accelerates beyond acc_lim_x");
  require(change(command.omega, last.omega, reference.omega) <=
              std::max(p.acc_lim_theta, p.braking_theta()) * period + kRounding,
          "the command accelerates beyond acc_lim_theta");
}

}  // namespace hidwa_local_planner::fuzz
