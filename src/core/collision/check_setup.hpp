// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/collision/escape.hpp"
#include "core/motion/comfort_turn.hpp"
#include "core/motion/cycle_start.hpp"
#include "core/movers/mover_check.hpp"

namespace hidwa_local_planner {

/// What the checks of one evaluation of the candidates know.
struct CheckSetup {
  const CycleStart* start = nullptr;
  bool turn_out = false;         // the robot may turn first where no motion leads out of collision
  bool steered = false;          // by an operator
  EscapeRule* escape = nullptr;  // where it applies
  ComfortTurn comfort{};         // of commands
  MoverCheck* movers = nullptr;  // where anything that moves is near
  MoverCheck* hidden = nullptr;  // where somebody may come out

  /// The robot overlaps an obstacle.
  bool escaping() const { return escape != nullptr && escape->overlaps(); }
};

}  // namespace hidwa_local_planner
