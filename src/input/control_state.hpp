// SPDX-License-Identifier: BSD-3-Clause
// From the input of a cycle to the intent, in steps:
// 1. when input ends that was in effect, a hold begins (Kalliokoski 2022, section III);
// 2. the input makes the facts, and the facts the next state (transition.hpp);
// 3. the state says how the planner takes u_h into account.
//
// States change here only, once a cycle. So only input that a cycle has seen can be released. Input that comes and goes
// between two cycles has no effect.
#pragma once

#include <optional>

#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/core/util/condition_timer.hpp"
#include "input/hold.hpp"
#include "input/input_channel.hpp"
#include "input/transition.hpp"

namespace hidwa_local_planner::input {

/// What a cycle came to: needed to know when a hold is rejected and when the robot is blocked.
struct CycleFeedback {
  bool operator_command_rejected = false;  // u_h itself
  bool stands = false;                     // the command asked for rest, and the robot is at rest
  bool goal_latched = false;
  bool new_goal = false;  // one began in this cycle, before all this
  Twist2 command;         // what was sent [m/s, rad/s]
};

/// What a cycle starts from.
struct CycleInput {
  double now = 0.0;             // [s]
  bool stop = false;            // the robot is to stop
  bool manual = false;          // SW: the operator has control
  bool goalless = false;        // the host has no goal
  const InputChannel& channel;  // of what steers
  const Parameters& parameters;
};

class ControlState {
 public:
  OperatorIntent update(const CycleInput& cycle);
  /// What became of the intent, at `now` [s].
  void debrief(double now, const CycleFeedback& feedback, const Parameters& parameters);
  void new_goal();
  OperatorStateId state() const { return state_; }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.state_, self.hold_, self.blocked_, self.goal_latched_, self.last_v_);
  }

 private:
  void begin_hold(const CycleInput& cycle);
  Facts facts(const CycleInput& cycle) const;
  OperatorIntent intent(const CycleInput& cycle) const;

  OperatorStateId state_ = OperatorStateId::autonomy;
  Hold hold_;
  ConditionTimer blocked_;  // rejections have held the steered robot at rest
  bool goal_latched_ = false;
  std::optional<double> last_v_;  // of the last command, where one is known [m/s]
};

}  // namespace hidwa_local_planner::input
