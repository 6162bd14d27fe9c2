// SPDX-License-Identifier: BSD-3-Clause
// Moved; this file goes with the next release.
#pragma once

#pragma message("hidwa_local_planner/core/period_watch.hpp is now hidwa_local_planner/control/period_watch.hpp")
#include "hidwa_local_planner/control/period_watch.hpp"
