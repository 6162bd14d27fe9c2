// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_2d_ros.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/Twist.h>
#include <tf2_ros/buffer.h>

#include <string>
#include <vector>

namespace nav_core {

/// What move_base asks of a local planner. initialize() is called once, before any other method.
class BaseLocalPlanner {
 public:
  virtual ~BaseLocalPlanner() = default;

  /// `name`: the planner's parameter and topic namespace below the node's own. `tf` and `costmap_ros` outlive
  /// the planner.
  virtual void initialize(std::string name, tf2_ros::Buffer* tf, costmap_2d::Costmap2DROS* costmap_ros) = 0;

  /// A new global plan, in the global planner's frame; called on every replan. False aborts the goal.
  virtual bool setPlan(const std::vector<geometry_msgs::PoseStamped>& plan) = 0;

  /// The velocity for the next control period. The host holds the local costmap's mutex during the call.
  /// False: no valid command; the host sends zero and replans.
  virtual bool computeVelocityCommands(geometry_msgs::Twist& cmd_vel) = 0;

  /// True once the goal of the last plan counts as reached.
  virtual bool isGoalReached() = 0;

 protected:
  BaseLocalPlanner() = default;
};

}  // namespace nav_core
