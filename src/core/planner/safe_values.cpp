// SPDX-License-Identifier: BSD-3-Clause
#include "core/planner/safe_values.hpp"

namespace hidwa_local_planner {

std::vector<std::string> make_safe(Parameters& parameters) {
  std::vector<std::string> reasons;
  if (parameters.admissibility != Admissibility::braking) return reasons;
  if (parameters.command == CommandPolicy::target) {
    parameters.command = CommandPolicy::feasible;
    reasons.push_back(
        "command: feasible is in force, not target: with target the base speeds up at limits of its own, which the "
        "braking check cannot know; admissibility: horizon allows target");
  }
  return reasons;
}

}  // namespace hidwa_local_planner
