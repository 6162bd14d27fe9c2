// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/twist_source.hpp"

#include <cmath>

#include "core/util/words.hpp"

namespace hidwa_local_planner::input {
namespace {

// Ten times what max_vel_x and max_vel_theta may be: a wish may be beyond the limits, but not beyond every robot.
constexpr double kFastest = 100.0;  // [m/s], [rad/s]

std::string fault_of(const char* field, double value, const char* unit) {
  if (std::abs(value) <= kFastest) return {};
  if (!std::isfinite(value)) return std::string(field) + " is not a finite number: look at the sender";
  const std::string most = worded(kFastest);
  return std::string(field) + " = " + worded(value, 3) + " is outside [-" + most + ", " + most + "] " + unit +
         ": look at the sender and its units";
}

}  // namespace

std::string fault_of(const TwistMessage& message) {
  const std::string fault = fault_of("linear.x", message.u.v, "m/s");
  return fault.empty() ? fault_of("angular.z", message.u.omega, "rad/s") : fault;
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
