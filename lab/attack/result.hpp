// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/types.hpp"
#include "walkers.hpp"

namespace hidwa_attack {

/// What became of one drive.
struct DriveResult {
  int cycles = 0;
  int moving = 0;                            // cycles in which it moved
  int threatened = 0;                        // moving cycles with an obstacle inside the stopping distance
  bool touched = false;                      // or broke the rule for robots that stand in collision
  double depth = 0.0;                        // of the deepest touch, or in a cell that it must not enter [m]
  int touched_at = -1;                       // [ms]
  int beyond = 0;                            // commands beyond the bound
  hidwa_local_planner::Twist2 beyond_worst;  // by how much [m/s, rad/s]
  int hard = 0;                              // commands beyond the acceleration limits
  double seconds = 0.0;                      // [s]
  double stood = 0.0;     // the longest, with the next metre of the plan open and nobody steering [s]
  Encounters encounters;  // with walkers
  // Of drives that stood in collision.
  bool stood_in = false;
  bool came_out = false;
  int entered = 0;              // cells that it must not enter
  double excess = 0.0;          // deeper in a neighbour than allowed [m]
  double growth = 0.0;          // of the total depth [m]
  double fastest_inside = 0.0;  // [m/s]
  double speed_bound = 0.0;     // [m/s]
};

}  // namespace hidwa_attack
