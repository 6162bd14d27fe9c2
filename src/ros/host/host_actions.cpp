// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/host_actions.hpp"

#include <algorithm>

#include <ros/time.h>
#include <topic_tools/shape_shifter.h>

namespace hidwa_local_planner {
namespace {

constexpr double kUntilStatus = 1.0;  // a goal that was sent has a status then [s]

bool pursued(const actionlib_msgs::GoalStatus& goal) {
  using Status = actionlib_msgs::GoalStatus;
  return goal.status == Status::PENDING || goal.status == Status::ACTIVE || goal.status == Status::PREEMPTING ||
         goal.status == Status::RECALLING;
}

}  // namespace

HostActions::HostActions() {
  using Goal = const topic_tools::ShapeShifter::ConstPtr&;
  const boost::function<void(Goal)> note_goal = [this](Goal) { goal_sent_ = ros::SteadyTime::now().toSec(); };
  const ros::NodeHandle outer, own("~");
  const std::vector<std::string> actions{outer.resolveName("move_base"), own.resolveName("move_base"),
                                         own.resolveName("exe_path"), own.resolveName("recovery")};
  for (const std::string& action : actions) {
    ros::NodeHandle handle = thread_.serve(ros::NodeHandle(action));
    const boost::function<void(const actionlib_msgs::GoalStatusArray::ConstPtr&)> note_status =
        [this, action](const actionlib_msgs::GoalStatusArray::ConstPtr& status) { hear_status(action, *status); };
    subscribers_.push_back(handle.subscribe<topic_tools::ShapeShifter>("goal", 10, note_goal));
    subscribers_.push_back(handle.subscribe<actionlib_msgs::GoalStatusArray>("status", 10, note_status));
  }
  thread_.start();
}

HostActions::~HostActions() { thread_.stop(); }

void HostActions::hear_status(const std::string& action, const actionlib_msgs::GoalStatusArray& status) {
  const bool any = std::any_of(status.status_list.begin(), status.status_list.end(), pursued);
  const std::lock_guard<std::mutex> lock(mutex_);
  active_[action] = any;
}

bool HostActions::any_goal(double now) const {
  if (now - goal_sent_ < kUntilStatus) return true;
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::any_of(active_.begin(), active_.end(), [](const auto& action) { return action.second; });
}

}  // namespace hidwa_local_planner
