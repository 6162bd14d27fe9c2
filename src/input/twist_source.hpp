// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "hidwa_local_planner/core/types.hpp"
#include "input/operator_source.hpp"

namespace hidwa_local_planner::input {

/// One velocity that another node made of an operator's input: a keyboard's, or a mapper's.
struct TwistMessage : OperatorMessage {
  Twist2 u;  // linear.x [m/s], angular.z [rad/s]
};

/// A Twist is the operator command itself, whatever the linear policy; but in shared control `current` leaves v to the
/// robot's own. Neutral below 0.005 m/s and 0.01 rad/s, else active. A message is faulty where a part is no number or
/// beyond 100 m/s or 100 rad/s. It steers where there is a twist_topic, but not in mode gesture. Its state is the
/// newest velocity that was taken.
class TwistSource : public SourceOf<TwistMessage, Twist2> {
 public:
  SourceKind kind() const override { return {"twist", false, false}; }
  SourceTopic topic(const Parameters& p) const override { return {"twist_topic", p.twist_topic, p.twist_topic}; }
  bool can_steer(const Parameters& p) const override {
    return p.mode != OperatorMode::gesture && !p.twist_topic.empty();
  }
  OperatorCommand command() const override;

 protected:
  ParsedMessage parsed(const TwistMessage& message) override;
  SourceReading taken(const TwistMessage& message, double now) override;
};

}  // namespace hidwa_local_planner::input
