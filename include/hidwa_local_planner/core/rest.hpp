// SPDX-License-Identifier: BSD-3-Clause
// When a robot is at rest. A measured velocity is noisy, a commanded one is not, so each has a rule of its own. There
// are no other rules.
#pragma once

#include <cmath>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Velocities that differ by no more are equal, and commands up to this size are zero: larger than rounding, smaller
/// than any actuator's step [m/s, rad/s].
constexpr double kCommandRounding = 1e-9;

/// A measured velocity [m/s, rad/s] is no more than noise: at most trans_stopped_velocity and rot_stopped_velocity.
/// False for what is not a number.
inline bool at_rest(const Twist2& measured, const Parameters& parameters) {
  return std::abs(measured.v) <= parameters.trans_stopped_velocity &&
         std::abs(measured.omega) <= parameters.rot_stopped_velocity;
}

/// A commanded velocity [m/s, rad/s] asks for rest: it is zero up to rounding.
inline bool commands_rest(const Twist2& command) {
  return std::abs(command.v) <= kCommandRounding && std::abs(command.omega) <= kCommandRounding;
}

/// The robot stands: the last command asked for rest, and it is at rest. A robot that has only just been told to drive
/// does not stand, nor does one that still rolls.
inline bool stands(const Twist2& last_command, const Twist2& measured, const Parameters& parameters) {
  return commands_rest(last_command) && at_rest(measured, parameters);
}

}  // namespace hidwa_local_planner
