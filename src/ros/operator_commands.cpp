// SPDX-License-Identifier: BSD-3-Clause
#include "ros/operator_commands.hpp"

#include <string>
#include <vector>

#include <ros/console.h>

namespace hidwa_local_planner {

OperatorCommands::OperatorCommands(ros::NodeHandle handle, OperatorInput& input, Reconfigure& reconfigure)
    : input_(input), reconfigure_(reconfigure) {
  set_mode_ = handle.subscribe<std_msgs::String>(
      "set_mode", 1, [this](const std_msgs::String::ConstPtr& message) { set_mode(*message); });
  // A stop waits for no other callback: a change of parameters may take long.
  ros::NodeHandle prompt = input_.serve(handle);
  const auto without_delay = ros::TransportHints().tcpNoDelay();
  using Request = const std_msgs::Bool::ConstPtr&;
  const boost::function<void(Request)> take_control = [this](Request request) { input_.take_control(request->data); };
  const boost::function<void(Request)> stop = [this](Request request) { input_.stop(request->data); };
  take_control_ = prompt.subscribe<std_msgs::Bool>("take_control", 1, take_control, nullptr, without_delay);
  stop_ = prompt.subscribe<std_msgs::Bool>("stop", 1, stop, nullptr, without_delay);
}

void OperatorCommands::set_mode(const std_msgs::String& message) {
  for (const std::string& fault : reconfigure_.set("mode", ParameterValue(message.data))) {
    ROS_ERROR("set_mode: %s", fault.c_str());
  }
}

}  // namespace hidwa_local_planner
