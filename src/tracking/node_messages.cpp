// SPDX-License-Identifier: BSD-3-Clause
#include "tracking/node_messages.hpp"

#include <algorithm>
#include <cmath>

#include "core/util/words.hpp"

namespace hidwa_local_planner {
namespace tracking {
namespace {

constexpr double kUpright = 0.95;     // cosine of how far a laser may be tilted: 18 degrees
constexpr double kShownFor = 0.5;     // [s]
constexpr double kDiscHeight = 0.05;  // [m]
constexpr double kArrowHeight = 0.1;  // above the floor [m]
constexpr double kTextHeight = 0.6;   // above the floor [m]

visualization_msgs::Marker marker_of(const MovingObstacles& message, const MovingObstacle& obstacle, const char* group,
                                     int type) {
  visualization_msgs::Marker m;
  m.header = message.header;
  m.ns = group;
  m.id = static_cast<int>(obstacle.id);
  m.type = type;
  m.action = visualization_msgs::Marker::ADD;
  m.pose.orientation.w = 1.0;
  m.lifetime = ros::Duration(kShownFor);
  m.color.r = 0.80F;  // told apart from the planner's markers, also by people who see few colours
  m.color.g = 0.47F;
  m.color.b = 0.65F;
  m.color.a = 1.0F;
  return m;
}

visualization_msgs::Marker disc(const MovingObstacles& message, const MovingObstacle& o) {
  visualization_msgs::Marker m = marker_of(message, o, "disc", visualization_msgs::Marker::CYLINDER);
  m.pose.position.x = o.position.x;
  m.pose.position.y = o.position.y;
  m.pose.position.z = 0.5 * kDiscHeight;
  m.scale.x = m.scale.y = std::max(2.0 * o.radius, 0.02);
  m.scale.z = kDiscHeight;
  m.color.a = 0.5F;
  return m;
}

visualization_msgs::Marker arrow(const MovingObstacles& message, const MovingObstacle& o) {
  visualization_msgs::Marker m = marker_of(message, o, "velocity", visualization_msgs::Marker::ARROW);
  m.points.resize(2);
  m.points[0].x = o.position.x;
  m.points[0].y = o.position.y;
  m.points[1].x = o.position.x + o.velocity.x;
  m.points[1].y = o.position.y + o.velocity.y;
  m.points[0].z = m.points[1].z = kArrowHeight;
  m.scale.x = 0.05;
  m.scale.y = 0.12;
  m.scale.z = 0.15;
  return m;
}

visualization_msgs::Marker label(const MovingObstacles& message, const MovingObstacle& o) {
  visualization_msgs::Marker m = marker_of(message, o, "id", visualization_msgs::Marker::TEXT_VIEW_FACING);
  m.pose.position.x = o.position.x;
  m.pose.position.y = o.position.y;
  m.pose.position.z = kTextHeight;
  m.scale.z = 0.25;
  m.text = format("%u: %.1f m/s", o.id, std::hypot(o.velocity.x, o.velocity.y));
  m.color.r = m.color.g = m.color.b = 0.1F;
  return m;
}

}  // namespace

std::string without_slash(const std::string& frame) {
  return frame.substr(std::min(frame.find_first_not_of('/'), frame.size()));
}

// The third column of the rotation says where the sensor's z axis points, the first where its x axis points.
Mounting mounting_of(const geometry_msgs::Transform& sensor) {
  const geometry_msgs::Quaternion& q = sensor.rotation;
  const double length = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  const double up = (q.w * q.w - q.x * q.x - q.y * q.y + q.z * q.z) / length;
  if (up > kUpright) return Mounting::upright;
  return up < -kUpright ? Mounting::upside_down : Mounting::tilted;
}

Pose2 to_sensor_pose(const geometry_msgs::Transform& sensor) {
  const geometry_msgs::Quaternion& q = sensor.rotation;
  const double x = q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z;
  const double y = 2.0 * (q.x * q.y + q.w * q.z);
  return {sensor.translation.x, sensor.translation.y, std::atan2(y, x)};
}

void to_range_scan(const sensor_msgs::LaserScan& message, Mounting mounting, RangeScan& scan) {
  const double sign = mounting == Mounting::upside_down ? -1.0 : 1.0;
  scan.stamp = message.header.stamp.toSec();
  scan.time_increment = message.time_increment;
  scan.angle_min = sign * message.angle_min;
  scan.angle_increment = sign * message.angle_increment;
  scan.range_min = message.range_min;
  scan.range_max = message.range_max;
  scan.ranges.assign(message.ranges.begin(), message.ranges.end());
}

MovingObstacles to_message(const MovingObstacleEstimates& obstacles, const std::string& frame, const ros::Time& stamp) {
  MovingObstacles message;
  message.header.frame_id = frame;
  message.header.stamp = stamp;
  for (const MovingObstacleEstimate& o : obstacles) {
    MovingObstacle m;
    m.id = o.id;
    m.position.x = o.position.x();
    m.position.y = o.position.y();
    m.velocity.x = o.velocity.x();
    m.velocity.y = o.velocity.y();
    m.radius = o.radius;
    m.position_deviation = o.position_deviation;
    m.velocity_deviation = o.velocity_deviation;
    for (const Point& p : o.points) {
      geometry_msgs::Point32 point;
      point.x = static_cast<float>(p.x());
      point.y = static_cast<float>(p.y());
      m.points.push_back(point);
    }
    message.obstacles.push_back(m);
  }
  return message;
}

std::vector<ObservedSector> to_message(const SensorSectors& view, Mounting mounting, const std::string& frame) {
  std::vector<ObservedSector> sectors;
  for (const SensorSector& sector : view) {
    const double middle = mounting == Mounting::upside_down ? -sector.pose.theta : sector.pose.theta;
    ObservedSector& told = sectors.emplace_back();
    told.frame_id = frame;
    told.angle_min = middle - 0.5 * sector.width;
    told.angle_max = middle + 0.5 * sector.width;
    told.range = sector.range;
  }
  return sectors;
}

visualization_msgs::MarkerArray to_markers(const MovingObstacles& message) {
  visualization_msgs::MarkerArray all;
  for (const MovingObstacle& o : message.obstacles) {
    all.markers.push_back(disc(message, o));
    all.markers.push_back(arrow(message, o));
    all.markers.push_back(label(message, o));
  }
  return all;
}

}  // namespace tracking
}  // namespace hidwa_local_planner
