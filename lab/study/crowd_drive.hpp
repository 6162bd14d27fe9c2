// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "sim/floor_ways.hpp"
#include "study/scene.hpp"

namespace hidwa_local_planner {
namespace study {

/// How people on a floor are, besides their seed.
struct Passers {
  int count = 20;
  double yielding = 0.5;                              // share that keeps away from the robot
  drive::Tracking tracking = drive::Tracking::truth;  // of the planner
};

/// Where people go on a scene's floor: half of the places lie beside the robot's way. The same for the same seed.
std::shared_ptr<const sim::FloorWays> ways_of_people(const Scene& scene, std::uint64_t seed);

/// A drive from the scene's start to its goal among people. All that is random depends on the seeds alone.
drive::DriveResult drive_among(const Scene& scene, const std::shared_ptr<const sim::FloorWays>& ways,
                               const Subject& subject, const Passers& passers, const std::string& mode,
                               std::uint64_t world_seed, std::uint64_t person_seed);

}  // namespace study
}  // namespace hidwa_local_planner
