// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/decision.hpp"

namespace hidwa_local_planner {

/// The candidate that a rule of the arbiter takes.
struct Proposal {
  int candidate = -1;  // -1: none
  ChoiceReport::Rule rule = ChoiceReport::Rule::none;
};

}  // namespace hidwa_local_planner
