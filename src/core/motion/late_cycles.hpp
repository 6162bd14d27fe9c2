// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace hidwa_local_planner {

/// For how long a cycle may brake that came `elapsed` [s] after the one before: what could have been braked since then,
/// one control `period` [s] at least and the longest one of late at most (PeriodWatch) [s].
inline double late_brake_period(double elapsed, double period, double longest) {
  return std::max(period, std::min(elapsed, longest));
}

/// How much later than a period after a command the first one to brake may take effect [s]. The next command may be
/// late, and the one after it: as long as each brakes as above, all of that together delays the braking by no more than
/// the latest of them.
inline double latest_hold(double period, double longest) { return 2.0 * std::max(0.0, longest - period); }

}  // namespace hidwa_local_planner
