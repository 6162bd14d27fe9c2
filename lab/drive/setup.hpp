// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "drive/ground.hpp"
#include "drive/local_costmap.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/situation.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "sim/diff_drive.hpp"
#include "sim/grid_route.hpp"
#include "sim/laser.hpp"
#include "sim/mover.hpp"
#include "sim/odometry.hpp"
#include "sim/operator.hpp"
#include "sim/operator_device.hpp"
#include "sim/polygon.hpp"
#include "sim/regions.hpp"
#include "tracking/tracker_settings.hpp"

namespace hidwa_local_planner {
namespace drive {

/// How often things happen; each is rounded to whole steps of 10 ms.
struct Rates {
  double control = 20.0;       // [Hz]
  double scan = 20.0;          // [Hz]
  double costmap = 10.0;       // [Hz]
  double plan = 1.0;           // [Hz], of the global plan
  double stick = 20.0;         // [Hz], of all of the person's messages
  double costmap_phase = 0.0;  // [s], how much later than the first control cycle the costmap is updated
};

/// Where the planner learns of people from: nowhere (they are cells of the costmap alone), their true states,
/// or what the tracker makes of the robot's scans.
enum class Tracking { none, truth, laser };

/// All that a drive depends on: equal setups give equal drives, but for the computing time.
struct DriveSetup {
  std::shared_ptr<const Ground> ground;
  std::shared_ptr<const sim::GridRoute> route;  // to the goal; null: made for this drive
  std::vector<sim::Region> regions;             // to avoid, seen by no sensor
  sim::Pose start;                              // map frame
  sim::Pose goal;                               // map frame

  sim::Polygon footprint;   // [m], of the robot itself
  Polygon outline;          // [m], what costmap and planner take it for, see outline.hpp
  sim::DriveLimits limits;  // of the robot itself, with its latency
  sim::OdometryNoise odometry_noise;
  sim::LaserSpec laser;
  sim::Pose laser_pose{0.10, 0.0, 0.0};  // robot frame

  CostmapSettings costmap;
  Parameters parameters;
  Sampling sampling;                      // of every cycle: fewer samples, as a busy machine leaves them; 0: all
  std::shared_ptr<sim::Operator> person;  // a new one for each drive: they remember; null: nobody
  // What the person holds, a new one for each drive: axes 0 and 1, button 0, the hand along y. Null: a stick.
  std::shared_ptr<sim::OperatorDevice> device;
  std::shared_ptr<sim::People> people;  // who walk around, new ones for each drive: they move; null: nobody
  Tracking tracking = Tracking::none;
  TrackerSettings tracker;  // with Tracking::laser
  double link_delay = 0.0;  // [s], from the person's hand to the planner
  Rates rates;

  std::uint64_t odometry_seed = 1;
  std::uint64_t laser_seed = 2;
  // Where set, the goal is reached as soon as the robot's centre is so near to it [m], whatever its heading and speed.
  double goal_radius = 0.0;
  bool end_at_contact = false;
  // Plan on what the laser has seen so far, on a grid of the map's geometry (what nobody has seen is free), instead of
  // on the map; `route` does not count then.
  bool explore = false;
  // How near to an obstacle the plan may lead [m]; 0: the outline's inscribed radius.
  double plan_radius = 0.0;

  double patience = 15.0;     // [s], of cycles without a command before the goal is given up
  double time_limit = 600.0;  // [s]
  bool keep_samples = true;
};

}  // namespace drive
}  // namespace hidwa_local_planner
