// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drive/drive.hpp"
#include "study/setting.hpp"

namespace hidwa_local_planner {
namespace study {

/// Where everybody drives, and the robot: the telepresence base of the package's demo.
struct Scene {
  std::shared_ptr<const drive::Ground> ground;
  std::shared_ptr<const sim::GridRoute> route;  // to the goal
  std::vector<sim::Region> regions;
  sim::Pose start;          // map frame
  sim::Pose goal;           // map frame
  drive::DriveSetup robot;  // its outline, limits, laser and odometry
};

/// Reads map and regions; start and goal, where not given, are those of the regions file. Throws UsageError.
Scene load_scene(const std::string& map, const std::string& regions, const std::optional<sim::Pose>& start,
                 const std::optional<sim::Pose>& goal);

/// A drive of the scene's robot from start to goal. The noise of laser and odometry depends on `world_seed` alone.
drive::DriveSetup drive_setup(const Scene& scene, const Subject& subject, std::uint64_t world_seed);

/// One drive, and what its person did wrong.
struct Driven {
  drive::DriveResult result;
  int errors = 0;  // SW: mode errors
};

/// Drives once. `subject` has mode and guard as the condition says. The noise of laser and odometry depends
/// on `world_seed` alone, all that the person does at random on `person_seed`.
Driven drive_once(const Scene& scene, const Subject& subject, std::uint64_t world_seed, std::uint64_t person_seed);

}  // namespace study
}  // namespace hidwa_local_planner
