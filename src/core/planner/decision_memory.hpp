// SPDX-License-Identifier: BSD-3-Clause
// Helpers for a decision that every cycle uses again, so that its lists and texts allocate nothing.
#pragma once

#include "core/cycle/conclusion.hpp"
#include "core/evaluation/critic_set.hpp"
#include "core/motion/cycle_start.hpp"
#include "hidwa_local_planner/core/decision.hpp"

namespace hidwa_local_planner {

/// Allocates what a decision with these critics may need.
void reserve(Decision& decision, const CriticSet& critics);
/// As a new one, but its lists and texts keep what is allocated.
void clear(Decision& decision);
/// What a cycle started from, and what it came to.
void write(const CycleStart& start, const Conclusion& conclusion, Decision& decision);

}  // namespace hidwa_local_planner
