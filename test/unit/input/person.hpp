// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/util/archive.hpp"
#include "input/gesture_source.hpp"
#include "input/operator_state_machine.hpp"
#include "input/stick_source.hpp"
#include "input/twist_source.hpp"

namespace hidwa_local_planner::input {

using State = OperatorStateId;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// The two buttons of the stick.
constexpr std::size_t kToggle = 0, kClutch = 0;  // by default
constexpr std::size_t kStop = 1;                 // by with_stop_button()

/// The defaults in a mode: max_vel_x 0.5 m/s, max_vel_theta 1 rad/s, input_timeout 0.5 s, delta 2 s.
inline Parameters in_mode(OperatorMode mode) {
  Parameters p;
  p.mode = mode;
  return p;
}

inline Parameters with_stop_button(OperatorMode mode = OperatorMode::joystick) {
  Parameters p = in_mode(mode);
  p.stop_button = static_cast<int>(kStop);
  return p;
}

inline StickMessage stick_at(double received, float angular, float linear = 0.0F) {
  StickMessage message;
  message.axes = {angular, linear};
  message.buttons = {0, 0};
  message.received = received;
  return message;
}

/// The stick with one of its two buttons held.
inline StickMessage button_at(double received, std::size_t held, float angular = 0.0F, float linear = 0.0F) {
  StickMessage message = stick_at(received, angular, linear);
  message.buttons[held] = 1;
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

/// The message as the node `sender` sends it.
template <typename Message>
Message from(const std::string& sender, Message message) {
  message.sender = sender;
  return message;
}

template <typename Message>
Message stamped(double stamp, Message message) {
  message.stamp = stamp;
  return message;
}

inline CycleFeedback rejected_at_rest() {
  CycleFeedback feedback;
  feedback.operator_command_rejected = true;
  feedback.stands = true;
  return feedback;
}

inline CycleFeedback at_goal() {
  CycleFeedback feedback;
  feedback.goal_latched = true;
  return feedback;
}

/// A person with a stick and the control loop, in one hand.
struct Person {
  explicit Person(const Parameters& parameters = Parameters()) : p(parameters) { configure(); }

  /// Takes `p` as it is now.
  void configure() { machine.configure(p); }
  void set_mode(OperatorMode mode) {
    p.mode = mode;
    configure();
  }

  std::string stick(double time, float angular, float linear = 0.0F) {
    return machine.receive(stick_at(time, angular, linear));
  }
  std::string button(double time, std::size_t held, float angular = 0.0F, float linear = 0.0F) {
    return machine.receive(button_at(time, held, angular, linear));
  }
  std::string twist(double time, double v, double omega) { return machine.receive(twist_at(time, v, omega)); }
  std::string hand(double time, double y) { return machine.receive(hand_at(time, 1.0, y, 1.0)); }

  OperatorIntent cycle(double time, const CycleFeedback& feedback = CycleFeedback()) {
    const OperatorIntent intent = machine.update(time);
    machine.debrief(time, feedback);
    return intent;
  }
  /// A message, and a cycle in the moment in which it arrives.
  OperatorIntent cycle_with(const OperatorMessage& message, const CycleFeedback& feedback = CycleFeedback()) {
    machine.receive(message);
    return cycle(message.received, feedback);
  }
  OperatorIntent cycle_with_stick(double time, float angular, float linear = 0.0F) {
    return cycle_with(stick_at(time, angular, linear));
  }
  OperatorIntent cycle_with_button(double time, std::size_t held, float angular = 0.0F, float linear = 0.0F) {
    return cycle_with(button_at(time, held, angular, linear));
  }
  OperatorIntent cycle_with_twist(double time, double v, double omega) { return cycle_with(twist_at(time, v, omega)); }

  /// Centred at `time`, deflected 0.05 s later, one cycle: SHARED (or what the parameters make of it).
  OperatorIntent steer(double time, float angular = 1.0F, float linear = 0.0F,
                       const CycleFeedback& feedback = CycleFeedback()) {
    stick(time, 0.0F);
    return cycle_with(stick_at(time + 0.05, angular, linear), feedback);
  }

  Parameters p;
  OperatorStateMachine machine;
};

inline Bytes saved(const OperatorStateMachine& machine) {
  Bytes bytes;
  ArchiveWriter write(bytes);
  machine.save(write);
  return bytes;
}

inline void load(OperatorStateMachine& machine, const Bytes& bytes) {
  ArchiveReader read(bytes);
  machine.load(read);
  EXPECT_TRUE(read.complete());
}

inline bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline void expect_intent(const OperatorIntent& intent, State state, Influence influence, double v, double omega) {
  EXPECT_STREQ(to_string(intent.state), to_string(state));
  EXPECT_EQ(static_cast<int>(intent.influence), static_cast<int>(influence));
  EXPECT_DOUBLE_EQ(intent.u_h.v, v);
  EXPECT_DOUBLE_EQ(intent.u_h.omega, omega);
}

inline void expect_autonomy(const OperatorIntent& intent) {
  expect_intent(intent, State::autonomy, Influence::none, 0.0, 0.0);
}

inline void expect_shared(const OperatorIntent& intent, double v, double omega) {
  expect_intent(intent, State::shared, Influence::shared, v, omega);
}

/// Straight on at `v`.
inline void expect_hold(const OperatorIntent& intent, double v) {
  expect_intent(intent, State::hold, Influence::shared, v, 0.0);
}

inline void expect_manual(const OperatorIntent& intent, double v, double omega) {
  expect_intent(intent, State::manual, Influence::direct, v, omega);
}

inline void expect_stopped(const OperatorIntent& intent) {
  expect_intent(intent, State::stopped, Influence::stop, 0.0, 0.0);
}

inline void expect_lost(const OperatorIntent& intent, Influence influence) {
  expect_intent(intent, State::lost, influence, 0.0, 0.0);
}

}  // namespace hidwa_local_planner::input
