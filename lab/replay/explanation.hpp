// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "record/cycle_replay.hpp"

namespace hidwa_local_planner {
namespace replay {

/// What a cycle was, in words: every candidate with every critic's score, who rejected what, why this one was chosen.
/// `replay` has just run and explained it. `time` [s] since the first record.
std::string explain(double time, record::CycleReplay& replay, const record::ReplayedCycle& cycle);

/// The same as JSON, for the picture: the scene and every candidate.
std::string explain_as_json(double time, record::CycleReplay& replay, const record::ReplayedCycle& cycle);

}  // namespace replay
}  // namespace hidwa_local_planner
