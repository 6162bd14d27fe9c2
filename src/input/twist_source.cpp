// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/twist_source.hpp"

namespace hidwa_local_planner::input {

std::string fault_of(const TwistMessage& message) {
  if (is_finite(message.u)) return {};
  return std::string(std::isfinite(message.u.v) ? "angular.z" : "linear.x") +
         " is not a finite number: look at the sender";
}

Wish wish_of(const TwistMessage& message, const Parameters& parameters) {
  Wish wish;
  wish.active = !(message.u == Twist2{});
  wish.u_h = message.u;
  if (!wish.active) wish.u_h = {};
  const bool shares = parameters.mode != OperatorMode::switching;
  if (shares && parameters.linear == LinearPolicy::current) wish.u_h.v = 0.0;
  return wish;
}

}  // namespace hidwa_local_planner::input
