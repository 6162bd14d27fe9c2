// SPDX-License-Identifier: BSD-3-Clause
#include "ros/host/host_goal.hpp"

#include "ros/conversions.hpp"

namespace hidwa_local_planner {
namespace {

constexpr unsigned kQueue = 10;  // goals that may come between two looks

FramedGoal to_goal(const geometry_msgs::PoseStamped& pose) {
  return {plain_frame(pose.header.frame_id), to_planned_pose(pose.pose)};
}

}  // namespace

HostGoal::HostGoal() {
  ros::NodeHandle host("~");
  if (host.hasParam("controllers")) return;  // Move Base Flex: its clients may plan for one goal and follow another
  subscriber_ = thread_.serve(host).subscribe("current_goal", kQueue, &HostGoal::hear, this);
  thread_.start();
}

HostGoal::~HostGoal() { thread_.stop(); }

void HostGoal::hear(const geometry_msgs::PoseStamped& goal) {
  const std::lock_guard<std::mutex> lock(mutex_);
  goals_.take(to_goal(goal), ros::Time::now().toSec());
}

bool HostGoal::leads_to_earlier_goal(const geometry_msgs::PoseStamped& end) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return goals_.leads_to_earlier_goal(to_goal(end));
}

bool HostGoal::leads_on(const geometry_msgs::PoseStamped& end) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return goals_.leads_on(to_goal(end), ros::Time::now().toSec());
}

}  // namespace hidwa_local_planner
