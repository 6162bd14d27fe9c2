// SPDX-License-Identifier: BSD-3-Clause
// The ROS side of every OperatorSource: its message type, and how a message becomes plain values.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "input/gesture_source.hpp"
#include "input/operator_message.hpp"
#include "ros/loop_time.hpp"

namespace hidwa_local_planner {

/// The topic of one OperatorSource.
struct OperatorDevice {
  std::string source;  // whose messages it makes (SourceKind::name)
  /// Makes messages of those of a topic. `handle` decides namespace and callback queue. Throws
  /// ros::InvalidNameException where the topic's name is invalid.
  std::function<ros::Subscriber(ros::NodeHandle handle, const std::string& topic)> subscribe;
  std::string topic;  // whose messages are taken; empty: none
  ros::Subscriber subscriber;
};

/// Takes a message for the source of that name; returns the fault in words where it was dropped. Called in the thread
/// that serves the handle.
using DeliverMessage = std::function<std::string(const std::string& source, const input::OperatorMessage& message)>;

/// One for each source that has a topic: the list to which another device is added.
std::vector<OperatorDevice> operator_devices(const DeliverMessage& deliver);

/// The hand as tf has it.
input::HandMessage to_hand(const geometry_msgs::TransformStamped& hand, const LoopTime& now);

}  // namespace hidwa_local_planner
