// SPDX-License-Identifier: BSD-3-Clause
#include "input/yielding.hpp"

#include <algorithm>

#include "input/transition.hpp"

namespace hidwa_local_planner::input {

bool attends(OperatorStateId state, bool manual) {
  return manual || is_steering(state) || state == OperatorStateId::manual || state == OperatorStateId::stopped;
}

Yielding::Phase Yielding::step(double now, bool stands, bool attended) {
  const double passed = last_ ? std::max(0.0, now - *last_) : 0.0;
  last_ = now;
  spent_ += passed;
  quiet_ = attended ? 0.0 : quiet_ + passed;
  if (stands && quiet_ >= settings_.quiet_time) return Phase::quiet;
  if (spent_ >= settings_.patience) return Phase::out_of_patience;
  return stands ? Phase::yielding : Phase::braking;
}

}  // namespace hidwa_local_planner::input
