// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/key_frames.hpp"
#include "sim/occupancy_map.hpp"
#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace sim {

/// A court that cylinders cross (Nair et al. 2022, "DynaBARN: Benchmarking metric ground navigation in dynamic
/// environments").
struct DynabarnWorld {
  int index = 0;
  std::string difficulty;                     // easy, medium or hard
  std::vector<std::vector<KeyFrame>> tracks;  // of each cylinder
};

constexpr double kDynabarnCylinder = 0.5;  // [m], radius
Pose dynabarn_start();                     // of every world
Pose dynabarn_goal();

/// The court's three walls, and the room beyond its open side that the robot may use.
OccupancyMap dynabarn_court(double resolution);

/// Its cylinders, `release` [s] after they began.
std::shared_ptr<KeyFramePeople> dynabarn_people(const DynabarnWorld& world, KeyMotion motion, double release);

/// Reads one world a line, `index difficulty | name t:x:y t:x:y ... | name ...`; lines with # are comments. Throws
/// std::runtime_error naming file, line, fault and remedy.
std::vector<DynabarnWorld> load_dynabarn_worlds(const std::string& file);

}  // namespace sim
}  // namespace hidwa_local_planner
