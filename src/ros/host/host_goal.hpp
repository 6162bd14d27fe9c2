// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "ros/callback_thread.hpp"
#include "ros/host/goal_succession.hpp"

namespace hidwa_local_planner {

/// The goal that move_base pursues, heard on its topic ~current_goal. Thread-safe.
class HostGoal {
 public:
  /// Of the node that loads the planner. Other hosts may follow a plan to another goal than the last one planned for:
  /// only move_base is listened to.
  HostGoal();
  ~HostGoal();
  /// True where a plan that ends at `end` leads to an earlier goal; see GoalSuccession.
  bool leads_to_earlier_goal(const geometry_msgs::PoseStamped& end) const;
  /// Such a plan may be followed until the next one comes.
  bool leads_on(const geometry_msgs::PoseStamped& end) const;

 private:
  void hear(const geometry_msgs::PoseStamped& goal);

  mutable std::mutex mutex_;
  GoalSuccession goals_;
  CallbackThread thread_;  // outlives the subscriber
  ros::Subscriber subscriber_;
};

}  // namespace hidwa_local_planner
