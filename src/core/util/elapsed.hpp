// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hidwa_local_planner {

/// `duration` has passed since `since`. A clock that went back counts as passed; all in [s].
inline bool elapsed(double since, double duration, double now) { return now < since || now - since >= duration; }

}  // namespace hidwa_local_planner
