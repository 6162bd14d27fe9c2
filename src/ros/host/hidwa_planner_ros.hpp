// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <nav_core/base_local_planner.h>
#include <ros/subscriber.h>

#include "ros/callback_thread.hpp"
#include "ros/host/goal_succession.hpp"
#include "ros/host/robot_keepers.hpp"

namespace hidwa_local_planner {

class DriveWithoutGoal;
class PlannerNode;

/// The local planner as move_base loads it. It throws nothing: an error is logged and the call fails, so that the host
/// stops the robot.
class HIDWAPlannerROS : public nav_core::BaseLocalPlanner {
 public:
  HIDWAPlannerROS();
  ~HIDWAPlannerROS() override;
  HIDWAPlannerROS(const HIDWAPlannerROS&) = delete;
  HIDWAPlannerROS& operator=(const HIDWAPlannerROS&) = delete;

  /// `name`: the namespace of parameters and topics below the node's own.
  void initialize(std::string name, tf2_ros::Buffer* tf, costmap_2d::Costmap2DROS* costmap_ros) override;
  /// On every replan; only a plan with a changed last pose is a new goal.
  bool setPlan(const std::vector<geometry_msgs::PoseStamped>& plan) override;
  /// One control cycle. True with a zero twist is a hold; false: nothing to send, the host is to replan or
  /// recover.
  bool computeVelocityCommands(geometry_msgs::Twist& cmd_vel) override;
  bool isGoalReached() override;

 private:
  void hear_goals();
  void hear(const geometry_msgs::PoseStamped& goal);
  bool plan_is_outdated() const;
  bool cycle(geometry_msgs::Twist& command);
  RestCommand keep();

  std::unique_ptr<PlannerNode> planner_;
  GoalSuccession goals_;                        // that move_base pursues
  std::unique_ptr<CallbackThread> thread_;      // hears them; outlives the subscriber
  ros::Subscriber goal_;                        // its topic current_goal
  FramedGoal end_;                              // of the plan
  int cycles_outdated_ = 0;                     // in which the plan led to an earlier goal, up to now
  std::unique_ptr<RobotKeepers::Entry> entry_;  // goes before what it asks
  std::unique_ptr<DriveWithoutGoal> drive_;     // likewise
};

}  // namespace hidwa_local_planner
