// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "drive/result.hpp"
#include "study/groups.hpp"
#include "study/passage_watch.hpp"

namespace hidwa_local_planner {
namespace study {

/// What a passage should be: no longer stand [s] than this, and no more stops.
constexpr double kLongestStand = 3.0;
constexpr int kMostStops = 2;

/// runs.csv of passages, a line a drive; summary.json by setting; ranking.csv by the number of drives that are not as
/// they should be.
Tables passage_tables();

/// The line of one run.
Row passage_row(const Plan& plan, const Run& run, std::uint64_t world_seed, const drive::DriveResult& result,
                const Passage& passage);

}  // namespace study
}  // namespace hidwa_local_planner
