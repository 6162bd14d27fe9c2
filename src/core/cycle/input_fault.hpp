// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/cycle/cycle.hpp"

namespace hidwa_local_planner {

/// False for a value that is not a number, or so large that it must be a fault.
bool plausible(const Twist2& u);
bool plausible(const Pose2& q);
bool plausible(const MovingObstacleEstimate& mover);
bool plausible(const GridView& grid);
/// Whether it may be so late, a pose so old, and a control period so long [s].
bool plausible_time(double time);
bool plausible_age(double age);
bool plausible_period(double period);

/// The fault of the cycle's input, in words; null where it has none.
const char* input_fault(const Cycle& cycle);

}  // namespace hidwa_local_planner
