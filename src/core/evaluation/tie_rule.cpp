// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/tie_rule.hpp"

#include <cmath>

namespace hidwa_local_planner {
namespace {

bool differ(double a, double b) { return std::abs(a - b) > kEqual; }

}  // namespace

TieRule::TieRule(const Parameters& parameters, const Twist2& last_command)
    : first_(parameters.method == Method::paper),
      last_(last_command),
      acc_x_(parameters.acc_lim_x),
      acc_theta_(parameters.acc_lim_theta) {}

double TieRule::change(const Twist2& u) const {
  return std::abs(u.v - last_.v) / acc_x_ + std::abs(u.omega - last_.omega) / acc_theta_;
}

bool TieRule::prefers(const Twist2& a, const Twist2& b) const {
  if (first_) {
    if (differ(a.v, b.v)) return a.v < b.v;
    return a.omega < b.omega - kEqual;
  }
  if (differ(change(a), change(b))) return change(a) < change(b);
  if (differ(std::abs(a.omega), std::abs(b.omega))) return std::abs(a.omega) < std::abs(b.omega);
  if (!differ(a.omega, b.omega)) return false;
  if (last_.omega != 0.0) return a.omega * last_.omega > 0.0;
  return a.omega > b.omega;
}

}  // namespace hidwa_local_planner
