// SPDX-License-Identifier: BSD-3-Clause
#include <move_base/move_base.h>

namespace move_base {

void MoveBase::onSimpleGoal(const geometry_msgs::PoseStamped& goal) {
  move_base_msgs::MoveBaseActionGoal action_goal;
  action_goal.header.stamp = ros::Time::now();
  action_goal.goal.target_pose = goal;
  action_goal_publisher_.publish(action_goal);
}

bool MoveBase::onMakePlan(nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response) {
  if (server_->isActive()) {
    ROS_ERROR("make_plan is answered only while no goal is active.");
    return false;
  }
  const boost::unique_lock<costmap_2d::Costmap2D::mutex_t> lock(*global_costmap_->getCostmap()->getMutex());
  geometry_msgs::PoseStamped start;
  if (request.start.header.frame_id.empty()) {
    if (!robotPose(*global_costmap_, start)) return false;
  } else {
    start = toGlobalFrame(request.start);
  }
  global_planner_.makePlan(start, toGlobalFrame(request.goal), double(request.tolerance), response.plan.poses);
  response.plan.header.frame_id = global_costmap_->getGlobalFrameID();
  response.plan.header.stamp = ros::Time::now();
  return true;
}

bool MoveBase::onClearCostmaps(std_srvs::Empty::Request& /*request*/, std_srvs::Empty::Response& /*response*/) {
  local_costmap_->resetLayers();
  global_costmap_->resetLayers();
  return true;
}

}  // namespace move_base
