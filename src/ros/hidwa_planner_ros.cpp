// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/hidwa_planner_ros.hpp"

#include <pluginlib/class_list_macros.hpp>

#include "hidwa_local_planner/ros/guarded.hpp"
#include "hidwa_local_planner/ros/shell.hpp"

namespace hidwa_local_planner {
namespace {

template <typename Call>
bool succeeds(const char* what, Call call) {
  return guarded("HIDWAPlannerROS", what, false, call);
}

}  // namespace

HIDWAPlannerROS::HIDWAPlannerROS() = default;
HIDWAPlannerROS::~HIDWAPlannerROS() = default;

void HIDWAPlannerROS::initialize(std::string name, tf2_ros::Buffer* tf,
                                 costmap_2d::Costmap2DROS* costmap_ros) {
  succeeds("initialize", [&] {
    start_shell(shell_, name, tf, costmap_ros);
    return true;
  });
}

bool HIDWAPlannerROS::setPlan(const std::vector<geometry_msgs::PoseStamped>& plan) {
  return succeeds("setPlan", [&] {
    if (shell_) shell_->set_plan(plan);
    return shell_ != nullptr;
  });
}

bool HIDWAPlannerROS::computeVelocityCommands(geometry_msgs::Twist& cmd_vel) {
  cmd_vel = geometry_msgs::Twist();
  return succeeds("computeVelocityCommands", [&] {
    if (!shell_) {
      ROS_ERROR_THROTTLE(1.0, "HIDWAPlannerROS was not initialized: nothing is driven");
      return false;
    }
    const CycleResult result = shell_->cycle();
    cmd_vel = to_message(result.command);
    return result.outcome != Outcome::fail;
  });
}

bool HIDWAPlannerROS::isGoalReached() {
  return succeeds("isGoalReached", [&] { return shell_ && shell_->goal_reached(); });
}

}  // namespace hidwa_local_planner

PLUGINLIB_EXPORT_CLASS(hidwa_local_planner::HIDWAPlannerROS, nav_core::BaseLocalPlanner)
