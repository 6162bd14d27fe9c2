// SPDX-License-Identifier: BSD-3-Clause
#include "control/fault_brake.hpp"

#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/rest.hpp"

namespace hidwa_local_planner {

FaultBrake::Command FaultBrake::brake(double now, const std::optional<Twist2>& velocity, const Twist2& last_command,
                                      const Parameters& parameters, const VelocityLimits& limits, double period) {
  if (!since_ || now < *since_) since_ = now;
  bool moving = !commands_rest(last_command);
  if (velocity) {
    moving = moving || !at_rest(*velocity, parameters);
  } else {
    moving = moving || now - *since_ <= limits.x.time_to_rest(limits.x.fastest()) + period;
  }
  if (!moving) return {};
  return {true, limits.brake(last_command, period)};
}

Outcome outcome_of(const FaultBrake::Command& braking, const OperatorIntent& intent) {
  if (braking.success) return Outcome::brake;
  return intent.influence == Influence::stop ? Outcome::hold : Outcome::fail;
}

}  // namespace hidwa_local_planner
