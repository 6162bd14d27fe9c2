// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <sensor_msgs/LaserScan.h>
#include <visualization_msgs/MarkerArray.h>

#include "sim/diff_drive.hpp"
#include "sim/laser.hpp"
#include "sim/polygon.hpp"
#include "sim/regions.hpp"

namespace hidwa_local_planner {
namespace sim {

/// A pose in `frame` as an odometry message; the velocity is the robot's own, in `child`.
nav_msgs::Odometry odometry_message(const ros::Time& stamp, const std::string& frame, const std::string& child,
                                    const Pose& pose, const Velocity& velocity);

/// The transform of `child` in `frame`, `height` [m] above it.
geometry_msgs::TransformStamped transform_message(const ros::Time& stamp, const std::string& frame,
                                                  const std::string& child, const Pose& pose, double height = 0.0);

/// A scan's head; the ranges are filled in by the caller.
sensor_msgs::LaserScan scan_message(const LaserSpec& laser, const std::string& frame, double period);

/// Outline and name of each region to avoid; those already crossed in another colour.
visualization_msgs::MarkerArray region_markers(const ros::Time& stamp, const std::string& frame,
                                               const RegionCounter& regions);

/// Forward and rotational velocity of a message [m/s, rad/s].
Velocity velocity_of(const geometry_msgs::Twist& twist);

/// Heading of a message's orientation [rad].
double yaw_of(const geometry_msgs::Quaternion& q);

}  // namespace sim
}  // namespace hidwa_local_planner
