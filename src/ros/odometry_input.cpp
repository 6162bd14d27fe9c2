// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/odometry_input.hpp"

#include <algorithm>
#include <cstdio>

#include "hidwa_local_planner/ros/conversions.hpp"

namespace hidwa_local_planner {

void OdometryInput::subscribe(ros::NodeHandle handle, const std::string& topic) {
  subscriber_.shutdown();
  forget();
  const auto callback = [this](const nav_msgs::Odometry::ConstPtr& message) {
    receive(*message, ros::Time::now().toSec());
  };
  subscriber_ =
      handle.subscribe<nav_msgs::Odometry>(topic, 1, callback, nullptr, ros::TransportHints().tcpNoDelay());
  const std::lock_guard<std::mutex> lock(mutex_);
  topic_ = subscriber_.getTopic();
}

void OdometryInput::receive(const nav_msgs::Odometry& message, double received) {
  const Twist2 velocity = to_twist(message.twist.twist);
  if (!is_finite(velocity)) {
    ROS_WARN_THROTTLE(1.0, "odometry with a velocity that is not a number was dropped");
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  velocity_ = velocity;
  stamp_ = message.header.stamp.toSec();
  received_ = received;
}

OdometryInput::Reading OdometryInput::read(double now, double timeout) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!velocity_) return {std::nullopt, "no odometry on " + topic_ + " yet: check odom_topic"};
  double age = now - received_;
  if (stamp_ > 0.0) age = std::max(age, now - stamp_);
  if (age <= timeout) return {velocity_, ""};
  char text[64];
  std::snprintf(text, sizeof(text), " is %.2f s old (odom_timeout %.2f s)", age, timeout);
  return {std::nullopt, "odometry on " + topic_ + text};
}

void OdometryInput::forget() {
  const std::lock_guard<std::mutex> lock(mutex_);
  velocity_.reset();
}

}  // namespace hidwa_local_planner
