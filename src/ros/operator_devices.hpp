// SPDX-License-Identifier: BSD-3-Clause
// The ROS side of every OperatorSource: its message type, and how a message becomes plain values.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>

#include "input/gesture_source.hpp"
#include "input/operator_message.hpp"
#include "ros/loop_time.hpp"

namespace hidwa_local_planner {

/// The topic of one OperatorSource.
class OperatorDevice {
 public:
  virtual ~OperatorDevice() = default;
  /// The source whose messages it makes (SourceKind::name).
  virtual const std::string& source() const = 0;
  /// From now on the messages of `topic` are taken; empty: none. `handle` decides namespace and callback queue. The
  /// same topic again changes nothing. Throws what roscpp throws at a name that is none.
  virtual void follow(ros::NodeHandle handle, const std::string& topic) = 0;
};

using OperatorDevices = std::vector<std::unique_ptr<OperatorDevice>>;

/// Takes a message for the source of that name; returns the fault in words where it was dropped. Called in the thread
/// that serves the handle.
using DeliverMessage = std::function<std::string(const std::string& source, const input::OperatorMessage& message)>;

/// One for each source that has a topic: the list to which another device is added.
OperatorDevices operator_devices(const DeliverMessage& deliver);

/// The hand as tf has it.
input::HandMessage to_hand(const geometry_msgs::TransformStamped& hand, const LoopTime& now);

}  // namespace hidwa_local_planner
