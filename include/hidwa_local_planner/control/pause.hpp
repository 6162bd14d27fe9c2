// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace hidwa_local_planner {

/// True when the host was in control itself during `silence` [s], at a nominal control `period` [s]: a slow host still
/// calls in this time, one that replans, recovers or waits for its costmap does not.
inline bool is_pause(double silence, double period) { return silence > std::max(4.0 * period, 0.3); }

}  // namespace hidwa_local_planner
