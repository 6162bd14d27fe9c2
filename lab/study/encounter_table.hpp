// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "drive/result.hpp"
#include "drive/setup.hpp"
#include "study/groups.hpp"

namespace hidwa_local_planner {
namespace study {

/// runs.csv of drives among what moves, a line a drive; summary.json by class, mode and setting; ranking.csv by
/// success.
Tables encounter_tables();

/// Where and when a run took place.
struct Scenery {
  std::string world;   // its index, or the map's name
  std::string klass;   // of worlds, over which means are taken: easy, medium, hard, or the number of people
  std::uint64_t seed;  // of the world
  double release;      // [s], on the clock of what moves
};

/// The line of one run.
Row encounter_row(const Plan& plan, const Run& run, const Scenery& scenery, const drive::DriveResult& result);

/// As --tracking has it.
std::string to_string(drive::Tracking tracking);

}  // namespace study
}  // namespace hidwa_local_planner
