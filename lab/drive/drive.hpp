// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "control/control_loop.hpp"
#include "drive/result.hpp"
#include "drive/setup.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "sim/world.hpp"

namespace hidwa_local_planner {
namespace drive {

/// A control cycle as an observer sees it, just before its command is sent. Poses are in the odometry's
/// frame, the world's in the map's. All of it is valid during the call only.
struct Cycle {
  double time;  // [s], since the start
  const Situation& situation;
  const GridView& grid;
  const OperatorIntent& intent;
  const Decision& decision;
  const Planner& planner;  // for its candidates()
  const sim::World& world;
  const control::ControlLoop& loop;
  const control::Observation& observation;
  const control::Result& result;
};
using Observer = std::function<void(const Cycle&)>;

/// A whole drive without ROS, in simulated time: the robot in its map, its laser, the local costmap that the
/// scans make in the odometry's frame, a global plan made anew every second and after every failure, the
/// person, and the planner, all run in the order in which move_base and the plugin run them. Throws
/// std::invalid_argument where the setup makes no sense.
DriveResult drive(const DriveSetup& setup, const Observer& observer = {});

/// The route to the setup's goal as a navfn plans it on the setup's costmap: made once, drives to the same goal may
/// share it. Needs ground, goal, outline and costmap.
std::shared_ptr<const sim::GridRoute> make_route(const DriveSetup& setup);

}  // namespace drive
}  // namespace hidwa_local_planner
