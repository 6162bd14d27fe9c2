// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

#include "ros/operator_input.hpp"
#include "ros/reconfigure.hpp"

namespace hidwa_local_planner {

/// What a device without the right buttons can ask for by topic, below the planner's name: `set_mode`
/// (std_msgs/String), `take_control` and `stop` (std_msgs/Bool).
class OperatorCommands {
 public:
  /// The mode is served by the handle's callback queue, the rest by that of the operator's messages; input and
  /// reconfigure must outlive it.
  OperatorCommands(ros::NodeHandle handle, OperatorInput& input, Reconfigure& reconfigure);

 private:
  void set_mode(const std_msgs::String& message);

  OperatorInput& input_;
  Reconfigure& reconfigure_;
  ros::Subscriber set_mode_, take_control_, stop_;
};

}  // namespace hidwa_local_planner
