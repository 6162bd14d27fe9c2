// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/operator_commands.hpp"

#include <string>
#include <vector>

#include <ros/console.h>

namespace hidwa_local_planner {

OperatorCommands::OperatorCommands(ros::NodeHandle handle, OperatorInput& person, Reconfigure& reconfigure)
    : person_(person), reconfigure_(reconfigure) {
  set_mode_ = handle.subscribe<std_msgs::String>(
      "set_mode", 1, [this](const std_msgs::String::ConstPtr& message) { set_mode(*message); });
  take_control_ = handle.subscribe<std_msgs::Bool>(
      "take_control", 1, [this](const std_msgs::Bool::ConstPtr& message) { person_.take_control(message->data); });
  stop_ = handle.subscribe<std_msgs::Bool>(
      "stop", 1, [this](const std_msgs::Bool::ConstPtr& message) { person_.stop(message->data); });
}

void OperatorCommands::set_mode(const std_msgs::String& message) {
  for (const std::string& fault : reconfigure_.set("mode", ParameterValue(message.data))) {
    ROS_ERROR("set_mode: %s", fault.c_str());
  }
}

}  // namespace hidwa_local_planner
