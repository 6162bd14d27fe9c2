// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "benchmark/cycle_times.hpp"

namespace hidwa_local_planner::test {

/// cycle/<candidates>/<cells a side>/<body>/<ground>: Planner::plan, another situation every time.
/// cycle_cached/...: the same situation again and again. cycle_watched/...: as cycle, and all candidates are checked,
/// as when somebody subscribes to what became of them. autonomy/...: as cycle, and nobody steers. cycle_among/...,
/// autonomy_among/...: the same with 20 people around.
void register_cycles(const Effort& effort);

/// naive_cycle/...: the same situations by naive_cycle().
void register_naive_cycles(const Effort& effort);

/// drive/office/alone|steered: whole drives through the office and back, without and with a person. The
/// counter times_real_time is the simulated time over that by the wall clock.
void register_drives(const Effort& effort);

/// samples/<v>x<omega>: what so many samples buy in the office. Counters: omega_change, the mean absolute change of
/// omega from command to command of autonomy [rad/s]; deviation and excess, where the person's own command is rejected:
/// the mean deviation of what is chosen instead, and its J above that with the finest samples.
void register_samples(const Effort& effort);

}  // namespace hidwa_local_planner::test
