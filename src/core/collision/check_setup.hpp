// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/collision/escape.hpp"
#include "core/motion/comfort_turn.hpp"
#include "core/motion/pending_motion_set.hpp"
#include "core/movers/mover_check.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// What the checks of one cycle start from. Poses are in the costmap frame.
struct CheckSetup {
  Pose2 start;                                // now
  Pose2 origin;                               // where `pending` begins: the pose as it was measured
  Twist2 reference;                           // what a command starts from [m/s, rad/s]
  const PendingMotionSet* pending = nullptr;  // until a command that is sent now takes effect
  double period = 0.05;                       // [s]
  double longest_period = 0.05;               // the next command comes no later [s]
  bool turn_out = false;                      // the robot may turn first where no motion leads out of collision
  bool steered = false;                       // by an operator
  EscapeRule* escape = nullptr;               // where it applies
  ComfortTurn comfort{};                      // of commands
  MoverCheck* movers = nullptr;               // where anything that moves is near

  /// The robot overlaps an obstacle.
  bool escaping() const { return escape != nullptr && escape->overlaps(); }
};

}  // namespace hidwa_local_planner
