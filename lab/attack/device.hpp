// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>

#include "hidwa_local_planner/core/operator_intent.hpp"
#include "input/operator_state_machine.hpp"
#include "input/stick_reading.hpp"
#include "random.hpp"
#include "spec.hpp"

namespace hidwa_attack {

/// A stick between a person and the planner, and what becomes of its messages on the way: see Link. It sends one
/// message a control cycle. What the person wants is said by deflection, by topics for taking control and stopping.
class Device {
 public:
  /// The machine must outlive it.
  Device(Link link, hidwa_local_planner::input::OperatorStateMachine& machine, std::uint64_t seed)
      : link_(link), machine_(machine), random_(seed) {}

  /// The person wants this at `now` [s]; limits in force.
  void send(double now, const hidwa_local_planner::OperatorIntent& wish, const Parameters& limits);

 private:
  using StickMessage = hidwa_local_planner::input::StickMessage;

  void say(const hidwa_local_planner::OperatorIntent& wish, const Parameters& limits);
  void spoil(double now, StickMessage& message);
  void deliver(double now);

  Link link_;
  hidwa_local_planner::input::OperatorStateMachine& machine_;
  Random random_;
  std::deque<StickMessage> under_way_;
  StickMessage frozen_;
  double frozen_until_ = 0.0, silent_until_ = 0.0, late_until_ = 0.0;  // [s]
  double begun_ = -1.0;                                                // [s]
  bool stops_ = false, manual_ = false;
};

}  // namespace hidwa_attack
