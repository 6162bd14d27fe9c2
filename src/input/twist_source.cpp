// SPDX-License-Identifier: BSD-3-Clause
#include "input/twist_source.hpp"

#include <cmath>

#include "core/util/words.hpp"

namespace hidwa_local_planner::input {
namespace {

// Ten times what max_vel_x and max_vel_theta may be: an operator command may be beyond the limits, but not beyond every
// robot.
constexpr double kFastest = 100.0;  // [m/s], [rad/s]

// Mappers, filters and worn sticks send small numbers in place of 0. No robot moves visibly at less than these.
constexpr double kNeutralSpeed = 0.005;  // [m/s]
constexpr double kNeutralTurn = 0.01;    // [rad/s]

bool is_neutral(const Twist2& u) { return std::abs(u.v) < kNeutralSpeed && std::abs(u.omega) < kNeutralTurn; }

std::string fault_of_part(const char* field, double value, const char* unit) {
  if (std::abs(value) <= kFastest) return {};
  if (!std::isfinite(value)) return std::string(field) + " is not a finite number: look at the sender";
  const std::string most = worded(kFastest);
  return std::string(field) + " = " + worded(value, 3) + " is outside [-" + most + ", " + most + "] " + unit +
         ": look at the sender and its units";
}

}  // namespace

ParsedMessage TwistSource::parsed(const TwistMessage& message) {
  ParsedMessage parsed;
  parsed.fault = fault_of_part("linear.x", message.u.v, "m/s");
  if (parsed.fault.empty()) parsed.fault = fault_of_part("angular.z", message.u.omega, "rad/s");
  parsed.idle = is_neutral(message.u);
  return parsed;
}

SourceReading TwistSource::taken(const TwistMessage& message, double) {
  state_ = message.u;
  SourceReading reading;
  reading.command = command();
  return reading;
}

OperatorCommand TwistSource::command() const {
  if (is_neutral(state_)) return {};
  OperatorCommand command{true, state_};
  const bool shared = parameters().mode != OperatorMode::switching;
  if (shared && parameters().linear == LinearPolicy::current) command.u_h.v = 0.0;
  return command;
}

}  // namespace hidwa_local_planner::input
