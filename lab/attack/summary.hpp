// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "conditions.hpp"
#include "result.hpp"

namespace hidwa_attack {

/// All drives under one condition.
struct Summary {
  explicit Summary(const Condition& of, const std::vector<DriveResult>& drives);

  std::string condition;
  bool promised = true;
  int drives = 0, cycles = 0;
  int contacts = 0;          // drives that touched, or broke the rule for robots in collision
  double worst_depth = 0.0;  // [m]
  std::uint64_t worst_seed = 0;
  int beyond = 0;                             // commands beyond the bound
  double beyond_v = 0.0, beyond_omega = 0.0;  // by how much at most [m/s, rad/s]
  std::uint64_t beyond_seed = 0;
  int hard = 0;         // commands beyond the acceleration limits
  double moving = 0.0;  // share of cycles
  int threatened = 0;   // moving cycles with an obstacle inside the stopping distance
  int stood_in = 0, came_out = 0, entered = 0, too_fast = 0;  // drives; `entered`: with forbidden cells
  double worst_growth = 0.0, worst_excess = 0.0;              // [m]
  std::vector<std::uint64_t> found;                           // seeds of what it found

  bool held() const { return found.empty(); }
};

}  // namespace hidwa_attack
