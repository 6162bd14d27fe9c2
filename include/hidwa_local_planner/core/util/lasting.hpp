// SPDX-License-Identifier: BSD-3-Clause
// Moved; this file goes with the next release.
#pragma once

#pragma message("hidwa_local_planner/core/util/lasting.hpp is now hidwa_local_planner/core/util/condition_timer.hpp")
#include "hidwa_local_planner/core/util/condition_timer.hpp"

namespace hidwa_local_planner {

using Lasting [[deprecated("is ConditionTimer")]] = ConditionTimer;

}  // namespace hidwa_local_planner
