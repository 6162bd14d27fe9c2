// SPDX-License-Identifier: BSD-3-Clause
#include "input/stick_source.hpp"

#include <string>

namespace hidwa_local_planner::input {

bool StickSource::same_mapping(const Parameters& a, const Parameters& b) const {
  return a.axis_angular == b.axis_angular && a.axis_linear == b.axis_linear &&
         a.axis_linear_rest == b.axis_linear_rest && a.enable_button == b.enable_button &&
         a.stop_button == b.stop_button && a.toggle_button == b.toggle_button && a.clutch_button == b.clutch_button &&
         a.clutch_axis == b.clutch_axis;
}

ParsedMessage StickSource::parsed(const StickMessage& message) {
  const StickUse use{parameters(), steers(), state_.linear_start.untouched(message, parameters())};
  ParsedMessage parsed;
  parsed.fault = read_stick(message, use, reading_);
  parsed.stop = stop_reading_of(message, use);
  if (!parsed.fault.empty()) return parsed;
  StickReading seen = reading_;
  if (state_.linear_start.doubts(message, parameters())) seen.linear = 0.0F;
  parsed.idle = !command_of(seen, parameters()).active && !seen.toggle && !seen.clutch;
  return parsed;
}

SourceReading StickSource::taken(const StickMessage& message, double now) {
  SourceReading reading;
  static_cast<StickReading&>(state_) = reading_;
  state_.linear_start.observe(message, parameters(), now);
  if (state_.linear_start.doubted()) state_.linear = 0.0F;
  reading.command = command();
  reading.buttons = Buttons{state_.toggle, state_.clutch};
  return reading;
}

std::string StickSource::advice() const {
  if (!state_.linear_start.doubted() || !reads_linear_axis({parameters(), steers()})) return {};
  const std::string name = "axes[" + std::to_string(parameters().axis_linear.index) + "]";
  const std::string end = state_.linear_start.end() > 0.0F ? "1" : "-1";
  return "The first movement of " + name + " led to its end " + end +
         ", as that of a trigger or a pedal does: it gives no speed until it has stood in its centre for 1 s. Let it "
         "go. If it rests at " +
         end + ", set axis_linear_rest to " + end + ", or axis_linear to another axis.";
}

}  // namespace hidwa_local_planner::input
