// SPDX-License-Identifier: BSD-3-Clause
#include "ros/plan_message.hpp"

#include "ros/conversions.hpp"

namespace hidwa_local_planner {
namespace {

std::string fault_of(const std::vector<geometry_msgs::PoseStamped>& plan) {
  if (plan.empty()) return "the plan is empty: the global planner found none";
  for (const geometry_msgs::PoseStamped& pose : plan) {
    if (!is_finite(to_pose(pose.pose))) return "the plan holds a pose that is not a number: check the global planner";
    if (pose.header.frame_id != plan.front().header.frame_id) {
      return "the plan mixes the frames " + plan.front().header.frame_id + " and " + pose.header.frame_id;
    }
  }
  if (plan.front().header.frame_id.empty()) return "the plan names no frame: check the global planner";
  return "";
}

}  // namespace

PlanMessage read_plan(const std::vector<geometry_msgs::PoseStamped>& plan) {
  PlanMessage read{fault_of(plan), "", {}};
  if (!read.fault.empty()) return read;
  read.frame = plain_frame(plan.front().header.frame_id);
  read.poses.reserve(plan.size());
  for (const geometry_msgs::PoseStamped& pose : plan) read.poses.push_back(to_planned_pose(pose.pose));
  return read;
}

}  // namespace hidwa_local_planner
