// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <actionlib_msgs/GoalStatusArray.h>
#include <ros/subscriber.h>

#include "ros/callback_thread.hpp"

namespace hidwa_local_planner {

/// Whether the host has a goal, heard on the topics of its actions that drive: move_base's, and those of Move Base
/// Flex. A goal that was sent counts at once, for a second, before any status names it. Thread-safe.
class HostActions {
 public:
  HostActions();
  ~HostActions();
  /// `now`: on the wall [s], see ros::SteadyTime.
  bool any_goal(double now) const;

 private:
  void hear_status(const std::string& action, const actionlib_msgs::GoalStatusArray& status);

  mutable std::mutex mutex_;
  std::map<std::string, bool> active_;   // by action
  std::atomic<double> goal_sent_{-1e9};  // on the wall [s]
  CallbackThread thread_;                // outlives the subscribers
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace hidwa_local_planner
