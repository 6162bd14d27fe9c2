// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/cycle_times.hpp"

namespace hidwa_local_planner::test {

/// cycle/<candidates>/<cells a side>/<body>/<ground>: Planner::plan, another situation every time.
/// cycle_cached/...: the same situation again and again.
void register_cycles(const Effort& effort);

/// naive_cycle/...: the same situations by naive_cycle().
void register_naive_cycles(const Effort& effort);

/// calibration/pose/<candidates>: the least that a pose can cost.
void register_calibration(const Effort& effort);

}  // namespace hidwa_local_planner::test
