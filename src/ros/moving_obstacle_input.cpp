// SPDX-License-Identifier: BSD-3-Clause
#include "ros/moving_obstacle_input.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <ros/console.h>
#include <tf2/exceptions.h>
#include <Eigen/Geometry>

#include "core/util/rotation.hpp"
#include "core/util/words.hpp"
#include "detector_messages.hpp"
#include "ros/conversions.hpp"

namespace hidwa_local_planner {
namespace {

// What is larger, faster or less known is a fault of its sender.
constexpr double kLargestRadius = 10.0;     // [m]
constexpr double kLargestDeviation = 10.0;  // [m, m/s]
constexpr double kFastestObstacle = 30.0;   // [m/s]
constexpr double kFarthestObstacle = 1e5;   // [m]

// A stamp may be ahead of the clock by this [s]: clocks differ a little.
constexpr double kAhead = 0.1;

bool within(double value, double most) { return value >= 0.0 && value <= most; }

// Why an obstacle cannot be used; null where it can.
const char* fault_of(const MovingObstacle& one) {
  if (!(std::hypot(one.position.x, one.position.y) <= kFarthestObstacle)) return "its position is not a number";
  if (!(std::hypot(one.velocity.x, one.velocity.y) <= kFastestObstacle)) {
    return "its velocity is not a number, or above 30 m/s";
  }
  if (!within(one.radius, kLargestRadius)) return "its radius is negative, above 10 m or not a number";
  if (!within(one.position_deviation, kLargestDeviation) || !within(one.velocity_deviation, kLargestDeviation)) {
    return "a deviation is negative, above 10 or not a number";
  }
  if (one.points.size() > MovingObstacleInput::kMostPoints) return "it has more than 4096 points";
  return nullptr;
}

void convert(const MovingObstacle& from, const Pose2& frame, double age, MovingObstacleEstimate& to) {
  const Point origin(frame.x, frame.y);
  const Rotation turn = Rotation::direction(frame.theta);
  to.id = from.id;
  to.position = origin + turn.apply({from.position.x, from.position.y});
  to.velocity = turn.apply({from.velocity.x, from.velocity.y});
  to.radius = from.radius;
  to.position_deviation = from.position_deviation;
  to.velocity_deviation = from.velocity_deviation;
  to.age = age;
  to.points.clear();
  for (const geometry_msgs::Point32& point : from.points) {
    if (std::isfinite(point.x) && std::isfinite(point.y)) to.points.push_back(origin + turn.apply({point.x, point.y}));
  }
}

// Where a frame was at a time; as tf knows it now where it does not reach that far yet, but by no more than `timeout`
// [s]. The fault in words.
std::string find_frame(const tf2::BufferCore& tf, const std::string& to, const std::string& from,
                       const ros::Time& stamp, double timeout, Pose2& found) {
  try {
    try {
      found = to_transform(tf.lookupTransform(to, from, stamp).transform).origin;
    } catch (const tf2::ExtrapolationException&) {
      const geometry_msgs::TransformStamped newest = tf.lookupTransform(to, from, ros::Time(0));
      if (!newest.header.stamp.isZero() && std::abs((stamp - newest.header.stamp).toSec()) > timeout) throw;
      found = to_transform(newest.transform).origin;
    }
  } catch (const tf2::TransformException& error) {
    return "no transform from the frame " + from + " of what moves to " + to + ": " + error.what();
  }
  return is_finite(found) ? "" : "the transform from the frame " + from + " of what moves is not a number";
}

// A sensor may be mounted upside down: the middle of what it looks at is turned in space. The fault in words.
std::string find_sector(const tf2::BufferCore& tf, const std::string& base, const ObservedSector& told,
                        SensorSector& found) {
  try {
    const geometry_msgs::Transform sensor =
        tf.lookupTransform(base, plain_frame(told.frame_id), ros::Time(0)).transform;
    const geometry_msgs::Quaternion& q = sensor.rotation;
    const double middle = 0.5 * (told.angle_min + told.angle_max);
    const Eigen::Vector3d to =
        Eigen::Quaterniond(q.w, q.x, q.y, q.z) * Eigen::Vector3d(std::cos(middle), std::sin(middle), 0.0);
    found.pose = {sensor.translation.x, sensor.translation.y, std::atan2(to.y(), to.x())};
    found.width = told.angle_max - told.angle_min;
    found.range = told.range;
  } catch (const tf2::TransformException& error) {
    return "no transform from the sensor's frame " + told.frame_id + " to " + base + ": " + error.what();
  }
  const bool usable = is_finite(found.pose) && found.width > 0.0 && found.range > 0.0 && std::isfinite(found.range);
  return usable ? "" : "what the sensor " + told.frame_id + " looks at is no sector";
}

}  // namespace

void MovingObstacleInput::subscribe(ros::NodeHandle handle, const std::string& topic) {
  subscriber_.shutdown();
  forget();
  const auto callback = [this](const topic_tools::ShapeShifter::ConstPtr& message) {
    receive(*message, LoopTime::now());
  };
  std::string resolved;
  if (!topic.empty()) {
    subscriber_ =
        handle.subscribe<topic_tools::ShapeShifter>(topic, 1, callback, nullptr, ros::TransportHints().tcpNoDelay());
    resolved = subscriber_.getTopic();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  sectors_of_.reset();
  status_ = {};
  status_.topic = std::move(resolved);
}

void MovingObstacleInput::receive(const topic_tools::ShapeShifter& message, const LoopTime& received) {
  const DetectedObstacles detected = read_detected(message);
  if (detected.message) return receive(detected.message, received);
  ROS_WARN_THROTTLE(2.0, "moving obstacles: %s", detected.fault.c_str());
  const std::lock_guard<std::mutex> lock(mutex_);
  unreadable_ = detected.fault;
  ++status_.messages;
  ++status_.refused;
}

void MovingObstacleInput::receive(const MovingObstacles::ConstPtr& message, const LoopTime& received) {
  std::size_t refused = 0;
  for (const MovingObstacle& one : message->obstacles) {
    const char* fault = fault_of(one);
    if (fault == nullptr) continue;
    ++refused;
    ROS_WARN_THROTTLE(2.0, "moving obstacle %u does not count: %s; check what publishes it", one.id, fault);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  newest_ = message;
  sectors_of_ = message;
  status_.sectors = message->sensor_sectors.size();
  unreadable_.clear();
  told_of_ = message->header.stamp.isZero() ? received.seconds : received.of(message->header.stamp);
  ++status_.messages;
  status_.refused += refused;
}

void MovingObstacleInput::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  newest_.reset();
  unreadable_.clear();
}

void MovingObstacleInput::read(double now, double timeout, const tf2::BufferCore& tf, const std::string& frame,
                               MovingObstacleEstimates& obstacles) {
  MovingObstacles::ConstPtr message;
  double told_of = 0.0;
  std::string unreadable;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    message = newest_;
    told_of = told_of_;
    unreadable = unreadable_;
  }
  obstacles.clear();
  if (!message) return report(0, 0.0, std::move(unreadable));
  const double age = now - told_of;
  if (age > timeout) {
    return report(0, age,
                  format("the newest message is %.2f s old (moving_obstacle_timeout %.2f s): nothing that "
                         "moves counts; check what publishes it",
                         age, timeout));
  }
  if (age < -kAhead) return report(0, age, "the newest message is from the future: synchronise the clocks");
  if (message->obstacles.size() > kMost) {
    return report(0, age, "a message has more than 256 obstacles: nothing that moves counts; check what publishes it");
  }
  Pose2 origin;
  const std::string from = plain_frame(message->header.frame_id);
  if (from != plain_frame(frame)) {
    std::string fault = find_frame(tf, plain_frame(frame), from, message->header.stamp, timeout, origin);
    if (!fault.empty()) return report(0, age, std::move(fault));
  }
  for (const MovingObstacle& one : message->obstacles) {
    if (fault_of(one) == nullptr) convert(one, origin, std::max(0.0, age), obstacles.emplace_back());
  }
  const bool all = obstacles.size() == message->obstacles.size();
  report(obstacles.size(), age,
         all ? std::move(unreadable) : "some obstacles of the newest message cannot be used: see the log");
}

void MovingObstacleInput::read_sectors(const tf2::BufferCore& tf, const std::string& base, SensorSectors& sectors) {
  MovingObstacles::ConstPtr message;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    message = sectors_of_;
  }
  sectors.clear();
  if (!message) return;
  for (const ObservedSector& one : message->sensor_sectors) {
    SensorSector sector;
    const std::string fault = find_sector(tf, plain_frame(base), one, sector);
    if (!fault.empty()) {
      ROS_WARN_THROTTLE(2.0, "sensor sectors: %s: it counts as seeing nothing", fault.c_str());
      sector = {};
    }
    sectors.push_back(sector);
  }
}

void MovingObstacleInput::report(std::size_t count, double age, std::string fault) {
  if (!fault.empty()) ROS_WARN_THROTTLE(2.0, "moving obstacles: %s", fault.c_str());
  const std::lock_guard<std::mutex> lock(mutex_);
  status_.count = count;
  status_.age = age;
  status_.fault.swap(fault);
}

MovingObstacleInput::Status MovingObstacleInput::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return status_;
}

}  // namespace hidwa_local_planner
