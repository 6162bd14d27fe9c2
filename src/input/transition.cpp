// SPDX-License-Identifier: BSD-3-Clause
#include "input/transition.hpp"

namespace hidwa_local_planner::input {

OperatorStateId next_state(OperatorStateId present, const Facts& facts) {
  if (facts.stop) return OperatorStateId::stopped;
  if (!facts.enabled) return OperatorStateId::autonomy;
  // A loss matters where something was in effect; it lasts until the input comes back, a stop in between or not.
  const bool can_lose = is_steering(present) || present == OperatorStateId::manual ||
                        present == OperatorStateId::lost || present == OperatorStateId::stopped;
  if (facts.lost && can_lose) return OperatorStateId::lost;
  if (facts.goalless) return facts.active ? OperatorStateId::manual : OperatorStateId::autonomy;
  if (facts.manual) return OperatorStateId::manual;
  if (facts.at_goal) return OperatorStateId::autonomy;
  if (facts.active) return facts.blocked ? OperatorStateId::blocked : OperatorStateId::shared;
  if (facts.holding) return OperatorStateId::hold;
  return OperatorStateId::autonomy;
}

bool is_steering(OperatorStateId state) {
  return state == OperatorStateId::shared || state == OperatorStateId::blocked;
}

}  // namespace hidwa_local_planner::input
