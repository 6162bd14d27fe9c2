// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/sim/occupancy_map.hpp"
#include "hidwa_local_planner/sim/operator.hpp"
#include "hidwa_local_planner/sim/regions.hpp"
#include "hidwa_local_planner/sim/world.hpp"

namespace hidwa_local_planner::test {

/// A whole drive without ROS: the true map's window as the local costmap, a global route replanned once a second, the
/// operator's state machine and the planner, against the simulated robot.
struct DriveSetup {
  std::shared_ptr<const sim::OccupancyMap> map;
  std::vector<sim::Region> regions;
  sim::Pose start, goal;                       // map frame
  Parameters parameters;
  std::shared_ptr<sim::Operator> person;       // nullptr: nobody
  sim::Polygon footprint;                      // of the robot itself [m]
  double robot_radius = 0.0;                   // the planner's circle around it; 0: the planner knows the footprint [m]
  double latency = 0.05;                       // of the base [s]
  double time_limit = 600.0;                   // [s]
};

/// One control cycle of a drive.
struct DriveSample {
  double time = 0.0;  // [s]
  sim::Pose pose;
  Twist2 command;     // [m/s, rad/s]
  Twist2 wanted;      // [m/s, rad/s]
  OperatorStateId state = OperatorStateId::autonomy;
  Outcome outcome = Outcome::drive;
  std::string problem;
};

struct DriveResult {
  bool arrived = false;
  double duration = 0.0;       // [s]
  double length = 0.0;         // [m]
  int contacts = 0;
  int regions_crossed = 0;
  std::size_t failures = 0;    // cycles that ended in failure
  std::size_t brakes = 0;      // cycles that braked for want of anything legal
  double roughness = 0.0;      // mean |change of omega| from command to command [rad/s]
  double planning = 0.0;       // wall clock in plan() [s]
  std::vector<DriveSample> samples;
};

DriveResult drive(const DriveSetup& setup);

}  // namespace hidwa_local_planner::test
