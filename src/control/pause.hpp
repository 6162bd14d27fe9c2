// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace hidwa_local_planner {

/// Whether a `silence` [s] between two cycles is a pause, at a nominal control `period` [s]. A slow host still calls
/// within this time. A host that replans, recovers or waits for its costmap does not.
inline bool is_pause(double silence, double period) { return silence > std::max(4.0 * period, 0.3); }

}  // namespace hidwa_local_planner
