// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/stick_source.hpp"

#include <cmath>
#include <cstddef>

#include "hidwa_local_planner/input/joystick_map.hpp"
#include "words.hpp"

namespace hidwa_local_planner::input {
namespace {

// Drivers overshoot by rounding: -32768 / 32767 is 1.00003.
constexpr float kRangeTolerance = 0.01F;

std::string has_only(std::size_t count, const std::string& things) {
  if (count == 0) return "the message has no " + things;
  return "the message has only " + things + " 0 to " + std::to_string(count - 1);
}

std::string check_numbers(const StickMessage& message) {
  for (std::size_t i = 0; i < message.axes.size(); ++i) {
    if (std::isfinite(message.axes[i])) continue;
    return "axes[" + std::to_string(i) + "] is not a finite number: look at the sender";
  }
  return {};
}

std::string check_axis(const StickMessage& message, const std::string& parameter, int index) {
  const auto i = static_cast<std::size_t>(index);
  if (index < 0 || i >= message.axes.size()) {
    return parameter + " = " + std::to_string(index) + ", but " + has_only(message.axes.size(), "axes") +
           ": set " + parameter + " to one that the device has";
  }
  if (std::abs(message.axes[i]) <= 1.0F + kRangeTolerance) return {};
  return "axes[" + std::to_string(i) + "] = " + number(static_cast<double>(message.axes[i])) +
         " is outside [-1, 1]: scale it at the sender, or set " + parameter + " to another axis";
}

std::string check_button(const StickMessage& message, int index) {
  if (index < 0) return {};
  const auto i = static_cast<std::size_t>(index);
  if (i >= message.buttons.size()) {
    return "enable_button = " + std::to_string(index) + ", but " +
           has_only(message.buttons.size(), "buttons") +
           ": set enable_button to one that the device has, or to -1 for none";
  }
  if (message.buttons[i] == 0 || message.buttons[i] == 1) return {};
  return "buttons[" + std::to_string(i) + "] = " + std::to_string(message.buttons[i]) +
         " is neither 0 nor 1: look at the sender, or set enable_button to another button";
}

// Axes are floats: a dead zone of 0.1 must hold the float 0.1 too, which as a double is a little more.
double map_float(float deflection, const Parameters& parameters, double maximum) {
  const auto dead_zone = static_cast<double>(static_cast<float>(parameters.dead_zone));
  return map_axis(static_cast<double>(deflection), dead_zone, parameters.exponent, maximum);
}

}  // namespace

std::string read_stick(const StickMessage& message, const Parameters& parameters, StickReading& reading) {
  const bool needs_linear = parameters.linear == LinearPolicy::axis;
  std::string fault = check_numbers(message);
  if (fault.empty()) fault = check_axis(message, "axis_angular", parameters.axis_angular);
  if (fault.empty() && needs_linear) fault = check_axis(message, "axis_linear", parameters.axis_linear);
  if (fault.empty()) fault = check_button(message, parameters.enable_button);
  if (!fault.empty()) return fault;

  reading = StickReading();
  reading.angular = message.axes[static_cast<std::size_t>(parameters.axis_angular)] *
                    static_cast<float>(parameters.axis_angular_sign);
  const auto linear = static_cast<std::size_t>(parameters.axis_linear);
  if (linear < message.axes.size()) {
    reading.linear = message.axes[linear] * static_cast<float>(parameters.axis_linear_sign);
  }
  reading.enabled = parameters.enable_button >= 0 &&
                    message.buttons[static_cast<std::size_t>(parameters.enable_button)] != 0;
  return {};
}

Wish wish_of(const StickReading& reading, const Parameters& parameters) {
  const bool by_axis = parameters.linear == LinearPolicy::axis;
  const double omega = map_float(reading.angular, parameters, parameters.max_vel_theta);
  const double v =
      by_axis ? map_float(reading.linear, parameters, parameters.max_vel_x) : parameters.max_vel_x;
  const bool deflected = omega != 0.0 || (by_axis && v != 0.0);
  Wish wish;
  wish.active = parameters.enable_button >= 0 ? reading.enabled : deflected;
  if (wish.active) wish.u_h = {v, omega};
  return wish;
}

}  // namespace hidwa_local_planner::input
