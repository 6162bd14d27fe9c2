// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "attack/cases.hpp"
#include "attack/result.hpp"
#include "study/groups.hpp"

namespace hidwa_local_planner {
namespace study {

/// What mixed drives are asked for as, and called in their ids.
constexpr const char* kMixed = "mixed";

/// What may be attacked: all conditions in their order, then mixed.
const std::vector<std::string>& attack_conditions();

/// runs.csv of an attack, a line a drive; summary.json by condition. The attack held where nothing within the promise
/// was found.
Tables attack_tables();

/// The line of one drive.
Row attack_row(const Run& run, const hidwa_attack::Case& drive, const hidwa_attack::DriveResult& result);

}  // namespace study
}  // namespace hidwa_local_planner
