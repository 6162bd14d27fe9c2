// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "hidwa_local_planner/core/planner.hpp"

namespace hidwa_local_planner {

/// What a cycle came to.
struct CycleResult {
  Outcome outcome = Outcome::fail;
  Twist2 command;     // sent, or zero on failure [m/s, rad/s]
  std::string fault;  // missing input; then there is no decision
  const Decision* decision = nullptr;
  Sampling sampling;  // in force
};

}  // namespace hidwa_local_planner
