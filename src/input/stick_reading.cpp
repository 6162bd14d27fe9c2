// SPDX-License-Identifier: BSD-3-Clause
#include "input/stick_reading.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/util/words.hpp"

namespace hidwa_local_planner::input {
namespace {

// Drivers overshoot by rounding: -32768 / 32767 is 1.00003.
constexpr float kRangeTolerance = 0.01F;

constexpr float kHeld = 0.5F;        // beyond it a clutch_axis is held
constexpr float kEnd = 0.99F;        // beyond it an axis is at an end
constexpr double kCentredFor = 1.0;  // a trigger on its way to its other end passes the centre faster [s]
constexpr int kStickAxes = 2;        // the first ones of every device with a stick

std::string has_only(std::size_t count, const std::string& things) {
  if (count == 0) return "the message has no " + things;
  return "the message has only " + things + " 0 to " + std::to_string(count - 1);
}

bool has(const std::vector<float>& axes, int index) {
  return index >= 0 && static_cast<std::size_t>(index) < axes.size();
}

bool in_range(float value) { return std::abs(value) <= 1.0F + kRangeTolerance; }  // not a number is not

std::string check_axis(const StickMessage& message, const std::string& parameter, int index) {
  if (!has(message.axes, index)) {
    return parameter + " = " + std::to_string(index) + ", but " + has_only(message.axes.size(), "axes") + ": set " +
           parameter + " to one that the device has";
  }
  const auto i = static_cast<std::size_t>(index);
  if (in_range(message.axes[i])) return {};
  const std::string name = "axes[" + std::to_string(i) + "]";
  if (!std::isfinite(message.axes[i])) {
    return name + " is not a finite number: look at the sender, or set " + parameter + " to another axis";
  }
  return name + " = " + worded(static_cast<double>(message.axes[i]), 3) +
         " is outside [-1, 1]: scale it at the sender, or set " + parameter + " to another axis";
}

std::string check_button(const StickMessage& message, const std::string& parameter, int index) {
  if (index < 0) return {};
  const auto i = static_cast<std::size_t>(index);
  if (i >= message.buttons.size()) {
    return parameter + " = " + std::to_string(index) + ", but " + has_only(message.buttons.size(), "buttons") +
           ": set " + parameter + " to one that the device has, or to -1 for none";
  }
  if (message.buttons[i] == 0 || message.buttons[i] == 1) return {};
  return "buttons[" + std::to_string(i) + "] = " + std::to_string(message.buttons[i]) +
         " is neither 0 nor 1: look at the sender, or set " + parameter + " to another button";
}

bool held(const StickMessage& message, int index) {
  return index >= 0 && message.buttons[static_cast<std::size_t>(index)] != 0;
}

std::string check_clutch(const StickMessage& message, const Parameters& parameters) {
  const int axis = parameters.clutch_axis.index;
  if (axis >= 0) return check_axis(message, "clutch_axis", axis);
  return check_button(message, "clutch_button", parameters.clutch_button);
}

bool clutch_held(const StickMessage& message, const Parameters& parameters) {
  const JoyAxis& axis = parameters.clutch_axis;
  if (axis.index < 0) return held(message, parameters.clutch_button);
  const float pressed = axis.turned(message.axes[static_cast<std::size_t>(axis.index)]);
  return pressed > kHeld;
}

bool needs_clutch(const Parameters& parameters) { return parameters.mode == OperatorMode::gesture; }

bool steers_both_axes(const Parameters& parameters) {
  return parameters.linear == LinearPolicy::axis || parameters.mode == OperatorMode::switching;
}

bool pull_stops(const StickUse& use) {
  const Parameters& parameters = use.parameters;
  if (parameters.stop_pull <= 0.0) return false;
  if (parameters.mode == OperatorMode::gesture) return true;
  const bool asks_for_reverse = parameters.linear == LinearPolicy::axis && parameters.min_vel_x < 0.0;
  return parameters.mode == OperatorMode::joystick && use.steers && !asks_for_reverse;
}

std::string check(const StickMessage& message, const StickUse& use) {
  const Parameters& parameters = use.parameters;
  std::string fault;
  if (use.steers) fault = check_axis(message, "axis_angular", parameters.axis_angular.index);
  const bool needs_linear = use.steers && steers_both_axes(parameters);
  const bool reads_linear = needs_linear || (has(message.axes, parameters.axis_linear.index) && pull_stops(use));
  if (fault.empty() && reads_linear) fault = check_axis(message, "axis_linear", parameters.axis_linear.index);
  if (fault.empty() && use.steers) fault = check_button(message, "enable_button", parameters.enable_button);
  if (fault.empty()) fault = check_button(message, "stop_button", parameters.stop_button);
  if (fault.empty() && needs_clutch(parameters)) fault = check_clutch(message, parameters);
  if (fault.empty() && parameters.mode == OperatorMode::switching) {
    fault = check_button(message, "toggle_button", parameters.toggle_button);
  }
  return fault;
}

// The value of an axis that was checked.
float axis(const StickMessage& message, int index) { return message.axes[static_cast<std::size_t>(index)]; }

// Whether the device has the axis, and it says what an axis can say.
bool has_sound(const StickMessage& message, int index) {
  return has(message.axes, index) && in_range(message.axes[static_cast<std::size_t>(index)]);
}

// The speed axis from its rest, forward positive.
float linear_of(float value, const StickUse& use) {
  const auto rest = static_cast<float>(use.parameters.axis_linear_rest);
  const float from_rest = use.linear_untouched && value == 0.0F ? 0.0F : (value - rest) / (1.0F + std::abs(rest));
  return use.parameters.axis_linear.turned(from_rest);
}

// Axes are floats: a dead zone of 0.1 must hold the float 0.1 too, which as a double is a little more.
double map_float(float deflection, const Parameters& parameters, double maximum) {
  const auto dead_zone = static_cast<double>(static_cast<float>(parameters.dead_zone));
  return map_axis(static_cast<double>(deflection), dead_zone, parameters.exponent, maximum);
}

// Kalliokoski 2022, the maps of (p_x, p_y) to (v_h, omega_h) in section IV-A.
Twist2 mapped(float angular, float linear, const Parameters& parameters) {
  const double omega = map_float(angular, parameters, parameters.max_vel_theta);
  if (steers_both_axes(parameters)) return {map_float(linear, parameters, parameters.max_vel_x), omega};
  return {parameters.linear == LinearPolicy::v_max ? parameters.max_vel_x : 0.0, omega};
}

}  // namespace

double map_axis(double deflection, double dead_zone, double exponent, double maximum) {
  const double size = std::min(std::abs(deflection), 1.0);
  if (!(size > dead_zone)) return 0.0;  // what is not a number is no deflection either
  return std::copysign(std::pow(size, exponent), deflection) * maximum;
}

bool AxisStart::Of::is(const StickMessage& message, const Parameters& parameters) const {
  return sender == message.sender && axes == message.axes.size() && index == parameters.axis_linear.index &&
         rest == parameters.axis_linear_rest;
}

void AxisStart::observe(const StickMessage& message, const Parameters& parameters, double now) {
  if (!has(message.axes, parameters.axis_linear.index)) return;
  if (!of_.is(message, parameters)) {
    *this = AxisStart();
    of_ = {message.sender, message.axes.size(), parameters.axis_linear.index, parameters.axis_linear_rest};
  }
  const float value = axis(message, parameters.axis_linear.index);
  const bool centred = std::abs(value) <= static_cast<float>(parameters.dead_zone);
  if (doubted_ && centred_ && now - centred_since_ >= kCentredFor) doubted_ = false;
  if (!moved_ && value != 0.0F) {
    moved_ = true;
    end_ = value > 0.0F ? 1.0F : -1.0F;
    doubted_ =
        std::abs(value) >= kEnd && parameters.axis_linear.index >= kStickAxes && parameters.axis_linear_rest == 0.0;
  }
  if (centred && !centred_) centred_since_ = now;
  centred_ = centred;
}

bool AxisStart::untouched(const StickMessage& message, const Parameters& parameters) const {
  return !moved_ || !of_.is(message, parameters);
}

bool AxisStart::doubts(const StickMessage& message, const Parameters& parameters) const {
  return doubted_ && of_.is(message, parameters);
}

bool reads_linear_axis(const StickUse& use) {
  return (use.steers && steers_both_axes(use.parameters)) || pull_stops(use);
}

std::string read_stick(const StickMessage& message, const StickUse& use, StickReading& reading) {
  const Parameters& parameters = use.parameters;
  std::string fault = check(message, use);
  if (!fault.empty()) return fault;
  reading = StickReading();
  if (has_sound(message, parameters.axis_angular.index)) {
    reading.angular = parameters.axis_angular.turned(axis(message, parameters.axis_angular.index));
  }
  if (has_sound(message, parameters.axis_linear.index)) {
    reading.linear = linear_of(axis(message, parameters.axis_linear.index), use);
  }
  if (use.steers) reading.enabled = held(message, parameters.enable_button);
  if (parameters.mode == OperatorMode::switching) reading.toggle = held(message, parameters.toggle_button);
  if (needs_clutch(parameters)) reading.clutch = clutch_held(message, parameters);
  return {};
}

StopReading stop_reading_of(const StickMessage& message, const StickUse& use) {
  const Parameters& parameters = use.parameters;
  StopReading reading;
  reading.shape = message.shape();
  const bool has_button = parameters.stop_button < static_cast<int>(message.buttons.size());
  reading.button = has_button && held(message, parameters.stop_button);
  if (!pull_stops(use) || !has(message.axes, parameters.axis_linear.index)) return reading;
  const auto forward = static_cast<double>(linear_of(axis(message, parameters.axis_linear.index), use));
  if (std::isfinite(forward)) reading.back = -forward;
  return reading;
}

OperatorCommand command_of(const StickReading& reading, const Parameters& parameters) {
  if (parameters.enable_button < 0) return command_of_deflection(reading.angular, reading.linear, parameters);
  if (!reading.enabled) return {};
  return {true, mapped(reading.angular, reading.linear, parameters)};
}

OperatorCommand command_of_deflection(float angular, float linear, const Parameters& parameters) {
  const Twist2 u = mapped(angular, linear, parameters);
  const bool deflected = u.omega != 0.0 || (steers_both_axes(parameters) && u.v != 0.0);
  return deflected ? OperatorCommand{true, u} : OperatorCommand{};
}

}  // namespace hidwa_local_planner::input
