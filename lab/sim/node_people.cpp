// SPDX-License-Identifier: BSD-3-Clause
#include "node_people.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <geometry_msgs/Point32.h>
#include <std_msgs/UInt32.h>
#include <visualization_msgs/MarkerArray.h>

#include "sim/floor_ways.hpp"
#include "sim/silhouettes.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr std::size_t kHaunts = 16;
constexpr double kWayMargin = 0.35;  // [m], of people's ways from walls

double at_least_zero(const ros::NodeHandle& node, const char* name, double usual) {
  const double value = node.param(name, usual);
  if (!std::isfinite(value) || value < 0.0) {
    throw std::runtime_error("parameter ~" + std::string(name) + " must not be negative");
  }
  return value;
}

// The robot's way, where ~goal_x and ~goal_y say where it will go.
Route robot_way(const ros::NodeHandle& node, const WorldSetup& world, const Eigen::Vector2d& start) {
  double x = 0.0, y = 0.0;
  if (!node.getParam("goal_x", x) || !node.getParam("goal_y", y)) return {};
  return GridRoute(*world.map, RouteClearance(), {x, y}, start).from(start);
}

Body body_of(const std::string& name) {
  if (name == "legs") return Body::legs;
  if (name == "whole") return Body::whole;
  throw std::runtime_error("parameter ~people_body is legs or whole, not '" + name + "'");
}

hidwa_local_planner::MovingObstacles message_of(const ros::Time& stamp, const std::string& frame,
                                                const std::vector<Mover>& movers,
                                                const std::vector<std::vector<Eigen::Vector2d>>& points) {
  hidwa_local_planner::MovingObstacles message;
  message.header.stamp = stamp;
  message.header.frame_id = frame;
  for (std::size_t k = 0; k < movers.size(); ++k) {
    hidwa_local_planner::MovingObstacle obstacle;
    obstacle.id = movers[k].id;
    obstacle.position.x = movers[k].position.x();
    obstacle.position.y = movers[k].position.y();
    obstacle.velocity.x = movers[k].velocity.x();
    obstacle.velocity.y = movers[k].velocity.y();
    obstacle.radius = movers[k].radius;
    for (const Eigen::Vector2d& point : k < points.size() ? points[k] : std::vector<Eigen::Vector2d>{}) {
      geometry_msgs::Point32 end;
      end.x = static_cast<float>(point.x());
      end.y = static_cast<float>(point.y());
      obstacle.points.push_back(end);
    }
    message.obstacles.push_back(obstacle);
  }
  return message;
}

visualization_msgs::Marker person_marker(const ros::Time& stamp, const std::string& frame, const Mover& mover) {
  constexpr double kHeight = 1.7;  // [m]
  visualization_msgs::Marker marker;
  marker.header.stamp = stamp;
  marker.header.frame_id = frame;
  marker.ns = "people";
  marker.id = static_cast<int>(mover.id);
  marker.type = visualization_msgs::Marker::CYLINDER;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.position.x = mover.position.x();
  marker.pose.position.y = mover.position.y();
  marker.pose.position.z = 0.5 * kHeight;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = 2.0 * mover.radius;
  marker.scale.z = kHeight;
  marker.color.r = 0.35F;
  marker.color.g = 0.25F;
  marker.color.b = 0.55F;
  marker.color.a = 0.6F;
  return marker;
}

}  // namespace

std::shared_ptr<People> read_people(const ros::NodeHandle& node, const WorldSetup& world) {
  CrowdSetup crowd;
  crowd.people = node.param("people", 0);
  if (crowd.people < 0) throw std::runtime_error("parameter ~people must not be negative");
  if (crowd.people == 0) return nullptr;
  const auto seed = static_cast<std::uint64_t>(node.param("people_seed", 1));
  crowd.seed = seed + 1;
  crowd.yielding = at_least_zero(node, "people_yielding", crowd.yielding);
  crowd.speed = at_least_zero(node, "people_speed", crowd.speed);
  crowd.max_speed = at_least_zero(node, "people_max_speed", crowd.max_speed);
  crowd.max_acc = at_least_zero(node, "people_max_acc", crowd.max_acc);
  crowd.body = body_of(node.param<std::string>("people_body", "legs"));
  const Eigen::Vector2d start(world.start.x, world.start.y);
  crowd.robot.position = start;
  crowd.robot.radius = circumscribed_radius(world.footprint);
  crowd.ways = std::make_shared<FloorWays>(
      *world.map, choose_places(*world.map, start, robot_way(node, world, start), kHaunts, kWayMargin, seed),
      kWayMargin);
  return std::make_shared<Crowd>(crowd);
}

NodePeople::NodePeople(ros::NodeHandle& node, std::string frame, bool tell_truth) : frame_(std::move(frame)) {
  truth_ = node.advertise<hidwa_local_planner::MovingObstacles>("moving_obstacles_truth", 10);
  if (tell_truth) told_ = node.advertise<hidwa_local_planner::MovingObstacles>("moving_obstacles", 10);
  markers_ = node.advertise<visualization_msgs::MarkerArray>("people", 1);
  moving_ = node.advertise<std_msgs::UInt32>("contacts_moving", 10, true);
  at_rest_ = node.advertise<std_msgs::UInt32>("contacts_at_rest", 10, true);
}

void NodePeople::scan(const OccupancyMap& map, const LaserSpec& spec, const Pose& sensor,
                      const std::vector<Mover>& movers, Random& random, std::vector<float>& ranges) {
  constexpr std::size_t kNobody = std::numeric_limits<std::size_t>::max();
  const Silhouettes people(movers);
  std::vector<std::size_t> met;
  const auto range = [&](double angle) {
    const double to_map = range_in(map, sensor.x, sensor.y, angle, spec.range_max);
    const Silhouettes::Hit hit = people.cast(sensor.x, sensor.y, angle, spec.range_max);
    met.push_back(hit.range < to_map ? hit.mover : kNobody);
    return std::min(to_map, hit.range);
  };
  sim::scan(range, spec, sensor.theta, random, ranges);
  points_.assign(movers.size(), {});
  for (std::size_t k = 0; k < met.size(); ++k) {
    const double length = static_cast<double>(ranges[k]);
    if (met[k] == kNobody || !std::isfinite(length)) continue;
    const double angle = sensor.theta + spec.angle_min() + static_cast<double>(k) * spec.angle_increment();
    points_[met[k]].emplace_back(sensor.x + length * std::cos(angle), sensor.y + length * std::sin(angle));
  }
}

void NodePeople::publish(const ros::Time& stamp, const std::vector<Mover>& movers) {
  const hidwa_local_planner::MovingObstacles message = message_of(stamp, frame_, movers, points_);
  truth_.publish(message);
  if (told_) told_.publish(message);
  if (markers_.getNumSubscribers() == 0) return;
  visualization_msgs::MarkerArray markers;
  for (const Mover& mover : movers) markers.markers.push_back(person_marker(stamp, frame_, mover));
  markers_.publish(markers);
}

void NodePeople::publish_touches(const PeopleWatch& watch) {
  const auto tell = [](const ros::Publisher& publisher, int count, int& known) {
    if (count == known) return;
    known = count;
    std_msgs::UInt32 message;
    message.data = static_cast<std::uint32_t>(count);
    publisher.publish(message);
  };
  tell(moving_, watch.touches_moving(), known_moving_);
  tell(at_rest_, watch.touches_at_rest(), known_at_rest_);
}

}  // namespace sim
}  // namespace hidwa_local_planner
