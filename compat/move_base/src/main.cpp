// SPDX-License-Identifier: BSD-3-Clause
#include <move_base/move_base.h>
#include <tf2_ros/transform_listener.h>

#include <exception>

int main(int argc, char** argv) {
  ros::init(argc, argv, "move_base_node");
  const ros::NodeHandle keeps_the_log_open;  // with the last handle the node, and its console, would be gone
  try {
    tf2_ros::Buffer buffer(ros::Duration(10.0));
    const tf2_ros::TransformListener listener(buffer);
    const move_base::MoveBase host(buffer);
    ros::spin();
  } catch (const std::exception& fault) {
    ROS_FATAL("move_base cannot start: %s", fault.what());
    return 1;
  }
  return 0;
}
