// SPDX-License-Identifier: BSD-3-Clause
#include "detector_messages.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include <boost/make_shared.hpp>

#include "foreign_messages.hpp"

namespace hidwa_local_planner {
namespace {

// What is usual for a detector at 10 Hz that does not say it.
constexpr double kPersonRadius = 0.3;        // [m]
constexpr double kPositionDeviation = 0.05;  // [m]
constexpr double kVelocityDeviation = 0.15;  // [m/s]

// What is slower stands: it is in the costmap [m/s].
constexpr double kStands = 1e-3;

// FNV-1a: people have names, movers have numbers.
std::uint32_t number_of(const std::string& name) {
  std::uint32_t number = 2166136261U;
  for (const char c : name) number = (number ^ static_cast<unsigned char>(c)) * 16777619U;
  return number;
}

MovingObstacle with_usual_deviations() {
  MovingObstacle one;
  one.position_deviation = kPositionDeviation;
  one.velocity_deviation = kVelocityDeviation;
  return one;
}

MovingObstacle to_mover(const foreign::Person& person) {
  MovingObstacle one = with_usual_deviations();
  one.id = number_of(person.name);
  one.position = person.position;
  one.velocity.x = person.velocity.x;
  one.velocity.y = person.velocity.y;
  one.radius = kPersonRadius;
  return one;
}

// The larger half axis of the velocity's ellipse [m/s].
double deviation_of(const geometry_msgs::TwistWithCovariance& velocities) {
  const double xx = velocities.covariance[0], xy = velocities.covariance[1], yy = velocities.covariance[7];
  const bool untold = (xx <= 0.0 && yy <= 0.0) || (xx == 1.0 && yy == 1.0 && xy == 0.0);
  return untold ? kVelocityDeviation : std::sqrt(0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy));
}

// A disc round the middle of the vertices that holds them. Without vertices its place is no number.
MovingObstacle to_mover(const foreign::Obstacle& obstacle) {
  MovingObstacle one = with_usual_deviations();
  const std::vector<geometry_msgs::Point32>& vertices = obstacle.polygon.points;
  const auto count = static_cast<double>(vertices.size());
  for (const geometry_msgs::Point32& vertex : vertices) {
    one.position.x += static_cast<double>(vertex.x);
    one.position.y += static_cast<double>(vertex.y);
  }
  one.position.x /= count;
  one.position.y /= count;
  for (const geometry_msgs::Point32& vertex : vertices) {
    const double x = static_cast<double>(vertex.x) - one.position.x, y = static_cast<double>(vertex.y) - one.position.y;
    one.radius = std::max(one.radius, std::hypot(x, y));
  }
  one.radius += obstacle.radius;
  one.id = static_cast<std::uint32_t>(obstacle.id);
  one.velocity.x = obstacle.velocities.twist.linear.x;
  one.velocity.y = obstacle.velocities.twist.linear.y;
  one.velocity_deviation = deviation_of(obstacle.velocities);
  return one;
}

bool stands(const MovingObstacle& one) { return std::hypot(one.velocity.x, one.velocity.y) < kStands; }

MovingObstacles::ConstPtr convert(const foreign::People& from) {
  const auto to = boost::make_shared<MovingObstacles>();
  to->header = from.header;
  for (const foreign::Person& person : from.people) to->obstacles.push_back(to_mover(person));
  return to;
}

MovingObstacles::ConstPtr convert(const foreign::ObstacleArray& from) {
  const auto to = boost::make_shared<MovingObstacles>();
  to->header = from.header;
  for (const foreign::Obstacle& obstacle : from.obstacles) {
    const MovingObstacle one = to_mover(obstacle);
    if (!stands(one)) to->obstacles.push_back(one);
  }
  return to;
}

template <typename Message>
bool is(const topic_tools::ShapeShifter& from) {
  return from.getDataType() == ros::message_traits::datatype<Message>();
}

}  // namespace

DetectedObstacles read_detected(const topic_tools::ShapeShifter& from) {
  try {
    if (is<MovingObstacles>(from)) return {from.instantiate<MovingObstacles>(), ""};
    if (is<foreign::People>(from)) return {convert(*from.instantiate<foreign::People>()), ""};
    if (is<foreign::ObstacleArray>(from)) return {convert(*from.instantiate<foreign::ObstacleArray>()), ""};
  } catch (const std::exception& error) {
    return {nullptr, "what says that it is " + from.getDataType() + " cannot be read as that: " + error.what()};
  }
  return {nullptr, from.getDataType() +
                       " came: send hidwa_local_planner/MovingObstacles, people_msgs/People or "
                       "costmap_converter/ObstacleArrayMsg"};
}

}  // namespace hidwa_local_planner
