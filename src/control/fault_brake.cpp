// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/control/fault_brake.hpp"

#include <algorithm>

#include "hidwa_local_planner/control/standing.hpp"

namespace hidwa_local_planner {
namespace {

double towards_zero(double value, double step) {
  return value > 0.0 ? std::max(0.0, value - step) : std::min(0.0, value + step);
}

}  // namespace

Twist2 brake_step(const Twist2& command, const Parameters& parameters, double period) {
  return {towards_zero(command.v, parameters.braking_x() * period),
          towards_zero(command.omega, parameters.braking_theta() * period)};
}

FaultBrake::Answer FaultBrake::answer(double now, const std::optional<Twist2>& velocity, const Twist2& last_command,
                                      const Parameters& parameters, double period) {
  if (!since_ || now < *since_) since_ = now;
  bool moving = !(last_command == Twist2{});
  if (velocity) {
    moving = moving || !stands(*velocity, parameters);
  } else {
    const double fastest = std::max(parameters.max_vel_x, -parameters.min_vel_x);
    moving = moving || now - *since_ <= fastest / parameters.braking_x() + period;
  }
  if (!moving) return {};
  return {true, brake_step(last_command, parameters, period)};
}

Outcome outcome_of(const FaultBrake::Answer& answer, const OperatorIntent& intent) {
  if (answer.success) return Outcome::brake;
  return intent.influence == Influence::stop ? Outcome::hold : Outcome::fail;
}

}  // namespace hidwa_local_planner
