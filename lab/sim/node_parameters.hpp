// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <ros/node_handle.h>

#include "sim/laser.hpp"
#include "sim/polygon.hpp"
#include "sim/world.hpp"

namespace hidwa_local_planner {
namespace sim {

/// Parameters of hidwa_sim_node, all private to it.
struct SimNodeParameters {
  WorldSetup world;
  LaserSpec laser;
  Pose laser_pose{0.10, 0.0, 0.0};   // robot frame, as in urdf/telepresence_base.urdf
  double laser_height = 0.28;        // [m]
  double rate = 1.0;                 // simulated seconds a second
  double odom_rate = 50.0;           // [Hz], simulated time
  double ground_truth_rate = 100.0;  // [Hz]
  double scan_rate = 20.0;           // [Hz]
  bool tell_truth = false;           // the planner is told the true states of people, as moving_obstacles
  bool follow_clock = false;         // another robot's node makes the time
  std::string map_frame = "map";
  std::string odom_frame = "odom";
  std::string base_frame = "base_link";
  std::string laser_frame = "laser";
};

/// Throws std::runtime_error or std::invalid_argument naming the parameter or file at fault.
SimNodeParameters read_parameters(const ros::NodeHandle& node);

/// A footprint given as a list of [x, y], or as a string of that form. Throws std::runtime_error.
Polygon read_footprint(const ros::NodeHandle& node, double radius);

}  // namespace sim
}  // namespace hidwa_local_planner
