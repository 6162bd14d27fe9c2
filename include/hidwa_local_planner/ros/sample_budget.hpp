// SPDX-License-Identifier: BSD-3-Clause
// Moved; this file goes with the next release.
#pragma once

#pragma message("hidwa_local_planner/ros/sample_budget.hpp is now hidwa_local_planner/control/sample_budget.hpp")
#include "hidwa_local_planner/control/sample_budget.hpp"
