// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hidwa_local_planner {

// Times nearer than this are the same: stamps are sums of periods.
inline constexpr double kSameTime = 1e-6;  // [s]

}  // namespace hidwa_local_planner
