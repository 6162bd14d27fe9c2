// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/Transform.h>
#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>
#include <visualization_msgs/MarkerArray.h>

#include "hidwa_local_planner/MovingObstacles.h"
#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/sensor_sector.hpp"
#include "tracking/range_scan.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// How a planar laser is mounted, seen from the fixed frame.
enum class Mounting { upright, upside_down, tilted };

/// A frame as tf2 names it: files and drivers from before tf2 put a slash in front.
std::string without_slash(const std::string& frame);

Mounting mounting_of(const geometry_msgs::Transform& sensor);

/// Position and heading of a sensor that is not tilted.
Pose2 to_sensor_pose(const geometry_msgs::Transform& sensor);

/// The scan without its poses. One that is mounted upside down is mirrored.
void to_range_scan(const sensor_msgs::LaserScan& message, Mounting mounting, RangeScan& scan);

MovingObstacles to_message(const MovingObstacleEstimates& obstacles, const std::string& frame, const ros::Time& stamp);

/// What a laser in `frame` looks at, from the field of view that the tracker made of its scans.
std::vector<ObservedSector> to_message(const SensorSectors& view, Mounting mounting, const std::string& frame);

/// For rviz: a disc, an arrow as long as one second of its way, and the id and speed of each. They vanish by
/// themselves.
visualization_msgs::MarkerArray to_markers(const MovingObstacles& message);

}  // namespace tracking
}  // namespace hidwa_local_planner
