// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Polygon.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/TwistWithCovariance.h>
#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <std_msgs/Header.h>

/// Messages of other packages as they come over the wire, so that these need not be there where the planner is built.
namespace hidwa_local_planner::foreign {

/// people_msgs/Person
struct Person {
  std::string name;
  geometry_msgs::Point position, velocity;  // [m, m/s]
  double reliability = 0.0;
  std::vector<std::string> tagnames, tags;
};

/// people_msgs/People
struct People {
  std_msgs::Header header;
  std::vector<Person> people;
};

/// costmap_converter/ObstacleMsg
struct Obstacle {
  std_msgs::Header header;
  geometry_msgs::Polygon polygon;  // [m]
  double radius = 0.0;             // around its vertices [m]
  std::int64_t id = 0;
  geometry_msgs::Quaternion orientation;
  geometry_msgs::TwistWithCovariance velocities;
};

/// costmap_converter/ObstacleArrayMsg
struct ObstacleArray {
  std_msgs::Header header;
  std::vector<Obstacle> obstacles;
};

}  // namespace hidwa_local_planner::foreign

// The sums are those of the packages' definitions (rosmsg md5).
namespace ros::message_traits {

template <>
struct DataType<hidwa_local_planner::foreign::People> {
  static const char* value() { return "people_msgs/People"; }
};
template <>
struct MD5Sum<hidwa_local_planner::foreign::People> {
  static const char* value() { return "18722f4b8db20cc2369740732357847b"; }
};
template <>
struct DataType<hidwa_local_planner::foreign::ObstacleArray> {
  static const char* value() { return "costmap_converter/ObstacleArrayMsg"; }
};
template <>
struct MD5Sum<hidwa_local_planner::foreign::ObstacleArray> {
  static const char* value() { return "8a1bdcde72c65ca7d3ce8ebf52d43516"; }
};

}  // namespace ros::message_traits

namespace ros::serialization {

template <>
struct Serializer<hidwa_local_planner::foreign::Person> {
  template <typename Stream, typename T>
  static void allInOne(Stream& stream, T person) {
    stream.next(person.name);
    stream.next(person.position);
    stream.next(person.velocity);
    stream.next(person.reliability);
    stream.next(person.tagnames);
    stream.next(person.tags);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

template <>
struct Serializer<hidwa_local_planner::foreign::People> {
  template <typename Stream, typename T>
  static void allInOne(Stream& stream, T people) {
    stream.next(people.header);
    stream.next(people.people);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

template <>
struct Serializer<hidwa_local_planner::foreign::Obstacle> {
  template <typename Stream, typename T>
  static void allInOne(Stream& stream, T obstacle) {
    stream.next(obstacle.header);
    stream.next(obstacle.polygon);
    stream.next(obstacle.radius);
    stream.next(obstacle.id);
    stream.next(obstacle.orientation);
    stream.next(obstacle.velocities);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

template <>
struct Serializer<hidwa_local_planner::foreign::ObstacleArray> {
  template <typename Stream, typename T>
  static void allInOne(Stream& stream, T array) {
    stream.next(array.header);
    stream.next(array.obstacles);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace ros::serialization
