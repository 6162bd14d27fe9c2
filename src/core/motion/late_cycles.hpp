// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace hidwa_local_planner {

/// How much braking a cycle may do, as a time [s]: the time since the cycle before, `elapsed` [s]; at least one control
/// `period` [s], and at most the `longest` of the last seconds (PeriodWatch).
inline double late_brake_period(double elapsed, double period, double longest) {
  return std::max(period, std::min(elapsed, longest));
}

/// How much later than one period after a command the first command to brake may take effect [s]. Several cycles in a
/// row may be late. Since each brakes as above, together they delay the braking no more than the latest one does alone.
inline double latest_hold(double period, double longest) { return 2.0 * std::max(0.0, longest - period); }

}  // namespace hidwa_local_planner
