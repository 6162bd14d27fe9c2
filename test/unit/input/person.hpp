// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "input/gesture_source.hpp"
#include "input/operator_state_machine.hpp"
#include "input/stick_source.hpp"
#include "input/twist_source.hpp"

namespace hidwa_local_planner::input {

inline StickMessage stick_at(double received, float angular, float linear = 0.0F) {
  StickMessage message;
  message.axes = {angular, linear};
  message.buttons = {0, 0};
  message.received = received;
  return message;
}

/// A tracked hand, whose orientation is one.
inline HandMessage hand_at(double received, double x, double y, double z) {
  HandMessage message;
  message.position = {x, y, z};
  message.orientation = {0.1, 0.0, 0.0, 0.995};
  message.received = received;
  return message;
}

inline TwistMessage twist_at(double received, double v, double omega) {
  TwistMessage message;
  message.u = {v, omega};
  message.received = received;
  return message;
}

/// A person with a stick and the control loop, in one hand.
struct Person {
  explicit Person(const Parameters& parameters = Parameters()) : p(parameters) { machine.configure(p); }

  std::string stick(double time, float angular, float linear = 0.0F) {
    return machine.receive(stick_at(time, angular, linear));
  }
  /// The stick with one of its two buttons held.
  std::string button(double time, std::size_t held, float angular = 0.0F, float linear = 0.0F) {
    StickMessage message = stick_at(time, angular, linear);
    message.buttons[held] = 1;
    return machine.receive(message);
  }
  std::string twist(double time, double v, double omega) { return machine.receive(twist_at(time, v, omega)); }
  std::string hand(double time, double y) { return machine.receive(hand_at(time, 1.0, y, 1.0)); }
  OperatorIntent cycle(double time, const CycleFeedback& feedback = CycleFeedback()) {
    const OperatorIntent intent = machine.update(time);
    machine.debrief(time, feedback);
    return intent;
  }
  /// Centred at `time`, deflected 0.05 s later, one cycle: SHARED (or what the parameters make of it).
  OperatorIntent steer(double time, float angular = 1.0F, float linear = 0.0F) {
    stick(time, 0.0F);
    stick(time + 0.05, angular, linear);
    return cycle(time + 0.05);
  }

  Parameters p;
  OperatorStateMachine machine;
};

inline void expect_intent(const OperatorIntent& intent, OperatorStateId state, Influence influence, double v,
                          double omega) {
  EXPECT_STREQ(to_string(intent.state), to_string(state));
  EXPECT_EQ(static_cast<int>(intent.influence), static_cast<int>(influence));
  EXPECT_DOUBLE_EQ(intent.u_h.v, v);
  EXPECT_DOUBLE_EQ(intent.u_h.omega, omega);
}

}  // namespace hidwa_local_planner::input
