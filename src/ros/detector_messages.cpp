// SPDX-License-Identifier: BSD-3-Clause
#include "detector_messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <stdexcept>
#include <vector>

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Polygon.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/TwistWithCovariance.h>
#include <ros/serialization.h>
#include <std_msgs/Header.h>
#include <boost/make_shared.hpp>

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

using Wire = ros::serialization::IStream;

/// What comes next over the wire. Throws where nothing more comes.
template <typename T>
T next(Wire& wire) {
  T value{};
  wire.next(value);
  return value;
}

/// Reads a people_msgs/Person.
void add_person(Wire& wire, MovingObstacles& to) {
  MovingObstacle one = with_usual_deviations();
  one.id = number_of(next<std::string>(wire));
  one.position = next<geometry_msgs::Point>(wire);
  const auto velocity = next<geometry_msgs::Point>(wire);
  one.velocity.x = velocity.x;
  one.velocity.y = velocity.y;
  one.radius = kPersonRadius;
  next<double>(wire);                    // reliability
  next<std::vector<std::string>>(wire);  // tagnames
  next<std::vector<std::string>>(wire);  // tags
  to.obstacles.push_back(one);
}

// The larger half axis of the velocity's ellipse [m/s].
double deviation_of(const geometry_msgs::TwistWithCovariance& velocities) {
  const double xx = velocities.covariance[0], xy = velocities.covariance[1], yy = velocities.covariance[7];
  const bool untold = (xx <= 0.0 && yy <= 0.0) || (xx == 1.0 && yy == 1.0 && xy == 0.0);
  return untold ? kVelocityDeviation : std::sqrt(0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy));
}

/// Reads a costmap_converter/ObstacleMsg: a disc round the middle of the vertices that holds them. Without vertices its
/// place is no number.
void add_obstacle(Wire& wire, MovingObstacles& to) {
  next<std_msgs::Header>(wire);
  const auto polygon = next<geometry_msgs::Polygon>(wire);
  const auto radius = next<double>(wire);  // around the vertices [m]
  const auto id = next<std::int64_t>(wire);
  next<geometry_msgs::Quaternion>(wire);
  const auto velocities = next<geometry_msgs::TwistWithCovariance>(wire);

  MovingObstacle one = with_usual_deviations();
  const auto count = static_cast<double>(polygon.points.size());
  for (const geometry_msgs::Point32& vertex : polygon.points) {
    one.position.x += static_cast<double>(vertex.x);
    one.position.y += static_cast<double>(vertex.y);
  }
  one.position.x /= count;
  one.position.y /= count;
  for (const geometry_msgs::Point32& vertex : polygon.points) {
    const double x = static_cast<double>(vertex.x) - one.position.x, y = static_cast<double>(vertex.y) - one.position.y;
    one.radius = std::max(one.radius, std::hypot(x, y));
  }
  one.radius += radius;
  one.id = static_cast<std::uint32_t>(id);
  one.velocity.x = velocities.twist.linear.x;
  one.velocity.y = velocities.twist.linear.y;
  one.velocity_deviation = deviation_of(velocities);
  const bool stands = std::hypot(one.velocity.x, one.velocity.y) < kStands;
  if (!stands) to.obstacles.push_back(one);
}

/// A header and a list, each element of which `add` reads. `sum`: of the type's definition (rosmsg md5).
MovingObstacles::ConstPtr read_list(const topic_tools::ShapeShifter& from, const char* sum,
                                    void (*add)(Wire& wire, MovingObstacles& to)) {
  if (from.getMD5Sum() != sum) throw std::runtime_error("its definition is another one");
  std::vector<std::uint8_t> bytes(from.size());
  ros::serialization::OStream copy(bytes.data(), from.size());
  from.write(copy);
  Wire wire(bytes.data(), from.size());
  const auto to = boost::make_shared<MovingObstacles>();
  to->header = next<std_msgs::Header>(wire);
  for (auto left = next<std::uint32_t>(wire); left > 0; --left) add(wire, *to);
  return to;
}

}  // namespace

DetectedObstacles read_detected(const topic_tools::ShapeShifter& from) {
  const std::string& type = from.getDataType();
  try {
    if (type == ros::message_traits::datatype<MovingObstacles>()) return {from.instantiate<MovingObstacles>(), ""};
    if (type == "people_msgs/People") return {read_list(from, "18722f4b8db20cc2369740732357847b", add_person), ""};
    if (type == "costmap_converter/ObstacleArrayMsg") {
      return {read_list(from, "8a1bdcde72c65ca7d3ce8ebf52d43516", add_obstacle), ""};
    }
  } catch (const std::exception& error) {
    return {nullptr, "what says that it is " + type + " cannot be read as that: " + error.what()};
  }
  return {nullptr, type +
                       " came: send hidwa_local_planner/MovingObstacles, people_msgs/People or "
                       "costmap_converter/ObstacleArrayMsg"};
}

}  // namespace hidwa_local_planner
