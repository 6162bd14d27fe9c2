// SPDX-License-Identifier: BSD-3-Clause
#include "ros/conversions.hpp"

#include <cmath>
#include <limits>

namespace hidwa_local_planner {

std::string plain_frame(const std::string& frame) {
  return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame;
}

double yaw_of(const geometry_msgs::Quaternion& q) {
  // Homogeneous in the quaternion: its length cancels.
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z);
}

Pose2 to_pose(const geometry_msgs::Pose& pose) { return {pose.position.x, pose.position.y, yaw_of(pose.orientation)}; }

Pose2 to_planned_pose(const geometry_msgs::Pose& pose) {
  const geometry_msgs::Quaternion& q = pose.orientation;
  Pose2 planned = to_pose(pose);
  if (q.x == 0.0 && q.y == 0.0 && q.z == 0.0 && q.w == 0.0) planned.theta = std::numeric_limits<double>::quiet_NaN();
  return planned;
}

geometry_msgs::Pose to_message(const Pose2& pose) {
  geometry_msgs::Pose message;
  message.position.x = pose.x;
  message.position.y = pose.y;
  message.orientation.z = std::sin(0.5 * pose.theta);
  message.orientation.w = std::cos(0.5 * pose.theta);
  return message;
}

Twist2 to_twist(const geometry_msgs::Twist& twist) { return {twist.linear.x, twist.angular.z}; }

geometry_msgs::Twist to_message(const Twist2& twist) {
  geometry_msgs::Twist message;
  message.linear.x = twist.v;
  message.angular.z = twist.omega;
  return message;
}

FrameTransform to_transform(const geometry_msgs::Transform& transform) {
  return {{transform.translation.x, transform.translation.y, yaw_of(transform.rotation)}};
}

Polygon to_polygon(const std::vector<geometry_msgs::Point>& points) {
  Polygon polygon;
  polygon.reserve(points.size());
  for (const geometry_msgs::Point& point : points) polygon.emplace_back(point.x, point.y);
  return polygon;
}

GridView view_of(const costmap_2d::Costmap2D& costmap) {
  GridView view;
  view.costs = costmap.getCharMap();
  view.size_x = static_cast<int>(costmap.getSizeInCellsX());
  view.size_y = static_cast<int>(costmap.getSizeInCellsY());
  view.resolution = costmap.getResolution();
  view.origin_x = costmap.getOriginX();
  view.origin_y = costmap.getOriginY();
  return view;
}

}  // namespace hidwa_local_planner
