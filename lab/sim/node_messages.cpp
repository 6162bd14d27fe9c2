// SPDX-License-Identifier: BSD-3-Clause
#include "node_messages.hpp"

#include <cmath>
#include <cstddef>

namespace hidwa_local_planner {
namespace sim {
namespace {

geometry_msgs::Quaternion quaternion(double yaw) {
  geometry_msgs::Quaternion q;
  q.z = std::sin(0.5 * yaw);
  q.w = std::cos(0.5 * yaw);
  return q;
}

geometry_msgs::Point point(const Eigen::Vector2d& p, double z) {
  geometry_msgs::Point result;
  result.x = p.x();
  result.y = p.y();
  result.z = z;
  return result;
}

visualization_msgs::Marker outline(const Region& region, bool crossed) {
  visualization_msgs::Marker marker;
  marker.ns = "outline";
  marker.type = visualization_msgs::Marker::LINE_STRIP;
  marker.scale.x = 0.06;
  marker.color.r = 1.0F;
  marker.color.g = crossed ? 0.0F : 0.6F;
  marker.color.a = 1.0F;
  for (const Eigen::Vector2d& corner : region.polygon) marker.points.push_back(point(corner, 0.02));
  marker.points.push_back(marker.points.front());
  return marker;
}

visualization_msgs::Marker label(const Region& region) {
  visualization_msgs::Marker marker;
  marker.ns = "name";
  marker.type = visualization_msgs::Marker::TEXT_VIEW_FACING;
  marker.text = region.name;
  marker.scale.z = 0.4;
  marker.color.r = marker.color.g = marker.color.b = 0.2F;
  marker.color.a = 1.0F;
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : region.polygon) center += corner;
  marker.pose.position = point(center / static_cast<double>(region.polygon.size()), 0.3);
  return marker;
}

}  // namespace

nav_msgs::Odometry odometry_message(const ros::Time& stamp, const std::string& frame, const std::string& child,
                                    const Pose& pose, const Velocity& velocity) {
  nav_msgs::Odometry message;
  message.header.stamp = stamp;
  message.header.frame_id = frame;
  message.child_frame_id = child;
  message.pose.pose.position.x = pose.x;
  message.pose.pose.position.y = pose.y;
  message.pose.pose.orientation = quaternion(pose.theta);
  message.twist.twist.linear.x = velocity.v;
  message.twist.twist.angular.z = velocity.omega;
  return message;
}

geometry_msgs::TransformStamped transform_message(const ros::Time& stamp, const std::string& frame,
                                                  const std::string& child, const Pose& pose, double height) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = frame;
  message.child_frame_id = child;
  message.transform.translation.x = pose.x;
  message.transform.translation.y = pose.y;
  message.transform.translation.z = height;
  message.transform.rotation = quaternion(pose.theta);
  return message;
}

sensor_msgs::LaserScan scan_message(const LaserSpec& laser, const std::string& frame, double period) {
  sensor_msgs::LaserScan message;
  message.header.frame_id = frame;
  message.angle_min = static_cast<float>(laser.angle_min());
  message.angle_increment = static_cast<float>(laser.angle_increment());
  message.angle_max = static_cast<float>(laser.angle_min() + (laser.beams - 1) * laser.angle_increment());
  message.scan_time = static_cast<float>(period);
  message.range_min = static_cast<float>(laser.range_min);
  message.range_max = static_cast<float>(laser.range_max);
  return message;
}

visualization_msgs::MarkerArray region_markers(const ros::Time& stamp, const std::string& frame,
                                               const RegionCounter& regions) {
  visualization_msgs::MarkerArray array;
  for (std::size_t i = 0; i < regions.regions().size(); ++i) {
    const Region& region = regions.regions()[i];
    for (visualization_msgs::Marker marker : {outline(region, regions.crossed(i)), label(region)}) {
      marker.header.stamp = stamp;
      marker.header.frame_id = frame;
      marker.id = static_cast<int>(i);
      marker.action = visualization_msgs::Marker::ADD;
      marker.pose.orientation.w = 1.0;
      array.markers.push_back(marker);
    }
  }
  return array;
}

Velocity velocity_of(const geometry_msgs::Twist& twist) { return {twist.linear.x, twist.angular.z}; }

double yaw_of(const geometry_msgs::Quaternion& q) {
  return std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
}

}  // namespace sim
}  // namespace hidwa_local_planner
