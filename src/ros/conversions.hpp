// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <costmap_2d/costmap_2d.h>
#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Twist.h>

#include "control/frame_transform.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// A frame's name as tf2 knows it: without a leading slash.
std::string plain_frame(const std::string& frame);

/// The heading of a quaternion of any length; 0 for an all-zero one, as some global planners leave it.
double yaw_of(const geometry_msgs::Quaternion& q);

Pose2 to_pose(const geometry_msgs::Pose& pose);
/// A pose of a plan, or a goal: a quaternion of no length is no heading, and its theta is not a number.
Pose2 to_planned_pose(const geometry_msgs::Pose& pose);
geometry_msgs::Pose to_message(const Pose2& pose);
Twist2 to_twist(const geometry_msgs::Twist& twist);
geometry_msgs::Twist to_message(const Twist2& twist);
FrameTransform to_transform(const geometry_msgs::Transform& transform);
Polygon to_polygon(const std::vector<geometry_msgs::Point>& points);

/// A view of the costmap's cells; valid as long as its mutex is held.
GridView view_of(const costmap_2d::Costmap2D& costmap);

}  // namespace hidwa_local_planner
