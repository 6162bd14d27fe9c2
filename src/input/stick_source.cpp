// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/input/stick_source.hpp"

namespace hidwa_local_planner::input {

bool StickSource::same_mapping(const Parameters& a, const Parameters& b) const {
  return a.axis_angular == b.axis_angular && a.axis_linear == b.axis_linear &&
         a.axis_angular_sign == b.axis_angular_sign && a.axis_linear_sign == b.axis_linear_sign &&
         a.enable_button == b.enable_button && a.stop_button == b.stop_button && a.toggle_button == b.toggle_button &&
         a.clutch_button == b.clutch_button && a.clutch_axis == b.clutch_axis &&
         a.clutch_axis_sign == b.clutch_axis_sign;
}

std::string StickSource::fault_of(const StickMessage& message) const {
  StickReading reading;
  return read_stick(message, use(), reading);
}

std::optional<StopReading> StickSource::stop_of(const StickMessage& message) const {
  return stop_reading_of(message, use());
}

bool StickSource::is_idle(const StickMessage& message) const {
  StickReading reading;
  read_stick(message, use(), reading);
  return !command_of(reading, parameters()).active && !reading.toggle && !reading.clutch;
}

SourceReading StickSource::take(const StickMessage& message, double) {
  SourceReading reading;
  reading.fault = read_stick(message, use(), state_);
  reading.command = command();
  reading.buttons = Buttons{state_.toggle, state_.clutch};
  return reading;
}

}  // namespace hidwa_local_planner::input
