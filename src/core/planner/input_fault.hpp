// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/planner/cycle.hpp"

namespace hidwa_local_planner {

/// False for what is not a number, or so large that it must be a fault.
bool plausible(const Twist2& u);
bool plausible(const Pose2& q);

/// Why a cycle cannot be planned with its input, in words; null where it can.
const char* input_fault(const Cycle& cycle);

}  // namespace hidwa_local_planner
