// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "study/barn_drive.hpp"
#include "study/groups.hpp"

namespace hidwa_local_planner {
namespace study {

/// runs.csv of BARN-2D, a line a world, mode and setting; summary.json by mode and setting; ranking.csv by
/// metric.
Tables barn_tables();

/// The line of one run.
Row barn_row(const Plan& plan, const Run& run, std::uint64_t world_seed, const drive::DriveResult& result,
             const BarnScore& score);

}  // namespace study
}  // namespace hidwa_local_planner
