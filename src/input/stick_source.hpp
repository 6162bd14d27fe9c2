// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/operator_source.hpp"
#include "input/stick_reading.hpp"

namespace hidwa_local_planner::input {

/// A stick with buttons, and what is known of its speed axis. How that began only judges messages to come: it is not
/// saved.
struct StickState : StickReading {
  AxisStart linear_start;
};

/// A stick with buttons. It steers unless another device is configured to; its buttons count in any case.
class StickSource : public SourceOf<StickMessage, StickState> {
 public:
  SourceKind kind() const override { return {"stick", true, false}; }
  SourceTopic topic(const Parameters& p) const override { return {"joy_topic", p.joy_topic, p.joy_topic}; }
  bool can_steer(const Parameters&) const override { return true; }
  bool same_mapping(const Parameters& a, const Parameters& b) const override;
  OperatorCommand command() const override { return command_of(state_, parameters()); }
  std::string advice() const override;

 protected:
  ParsedMessage parsed(const StickMessage& message) override;
  SourceReading taken(const StickMessage& message, double now) override;

 private:
  StickReading reading_;  // of the message parsed last
};

}  // namespace hidwa_local_planner::input
