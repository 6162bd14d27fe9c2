// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/util/condition_timer.hpp"

namespace hidwa_local_planner {

/// The former name.
using Lasting = ConditionTimer;

}  // namespace hidwa_local_planner
