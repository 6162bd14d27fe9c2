// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/operator_intent.hpp"

namespace hidwa_local_planner::input {

/// All that the next state depends on, besides the present one.
struct Facts {
  bool enabled = false;   // the mode is not off
  bool stop = false;      // the operator stops the robot
  bool manual = false;    // SW: the operator has taken control
  bool lost = false;      // active input fell silent and has not come back
  bool active = false;    // the operator gives input, and it counts
  bool blocked = false;   // rejections have held the steered robot at rest for long
  bool holding = false;   // a release was less than delta ago
  bool goalless = false;  // the host has no goal: who gives input drives
  bool at_goal = false;   // the goal is latched: steering and holding no longer count
};

/// The state machine proper: a pure function. The first rule that applies decides, in this order: stopped, off, lost,
/// without a goal, manual, at the goal, steering, holding, autonomy. Stopping outranks all: a robot that was told to
/// stop stays so until it is told otherwise.
OperatorStateId next_state(OperatorStateId present, const Facts& facts);

/// The operator is bending the motion: SHARED or BLOCKED.
bool is_steering(OperatorStateId state);

}  // namespace hidwa_local_planner::input
