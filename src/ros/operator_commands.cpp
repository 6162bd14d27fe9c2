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
  // A stop waits for no other callback: a change of parameters may take long.
  ros::NodeHandle prompt = person_.serve(handle);
  const auto without_delay = ros::TransportHints().tcpNoDelay();
  using Said = const std_msgs::Bool::ConstPtr&;
  const boost::function<void(Said)> take_control = [this](Said said) { person_.take_control(said->data); };
  const boost::function<void(Said)> stop = [this](Said said) { person_.stop(said->data); };
  take_control_ = prompt.subscribe<std_msgs::Bool>("take_control", 1, take_control, nullptr, without_delay);
  stop_ = prompt.subscribe<std_msgs::Bool>("stop", 1, stop, nullptr, without_delay);
}

void OperatorCommands::set_mode(const std_msgs::String& message) {
  for (const std::string& fault : reconfigure_.set("mode", ParameterValue(message.data))) {
    ROS_ERROR("set_mode: %s", fault.c_str());
  }
}

}  // namespace hidwa_local_planner
