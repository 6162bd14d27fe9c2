// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/plan_tracker.hpp"

#include <cmath>
#include <utility>

namespace hidwa_local_planner {
namespace {

// What a transform to and fro may change of a goal.
constexpr double kSamePosition = 1e-3;  // [m]
constexpr double kSameHeading = 1e-3;   // [rad]

bool same_goal(const Pose2& a, const Pose2& b) {
  return distance(a, b) <= kSamePosition && std::abs(wrap_angle(a.theta - b.theta)) <= kSameHeading;
}

std::string fault_of(const std::vector<geometry_msgs::PoseStamped>& plan) {
  if (plan.empty()) return "the plan is empty: the global planner found none";
  for (const geometry_msgs::PoseStamped& pose : plan) {
    if (!is_finite(to_pose(pose.pose))) return "the plan holds a pose that is not a number";
    if (pose.header.frame_id != plan.front().header.frame_id) {
      return "the plan mixes the frames " + plan.front().header.frame_id + " and " + pose.header.frame_id;
    }
  }
  if (plan.front().header.frame_id.empty()) return "the plan names no frame";
  return "";
}

}  // namespace

bool PlanTracker::set(const std::vector<geometry_msgs::PoseStamped>& plan) {
  fault_ = fault_of(plan);
  if (!fault_.empty()) {
    plan_.set_plan({});
    return false;
  }
  std::vector<Pose2> poses;
  poses.reserve(plan.size());
  for (const geometry_msgs::PoseStamped& pose : plan) poses.push_back(to_pose(pose.pose));
  const Pose2 goal = poses.back();
  std::string frame = plan.front().header.frame_id;
  if (frame.front() == '/') frame.erase(0, 1);  // tf2 knows no leading slash
  const bool is_new = !has_goal_ || frame != frame_ || !same_goal(goal, goal_);
  plan_.set_plan(std::move(poses));
  frame_ = frame;
  // The goal that the latches belong to stays the reference: a sum of tiny changes is a change.
  if (is_new) goal_ = goal;
  has_goal_ = true;
  return is_new;
}

void PlanTracker::window(const FrameTransform& transform, const Pose2& robot, double behind, double ahead,
                         std::vector<Pose2>& window) {
  const PlanWindow::Range range = plan_.around(transform.apply_inverse(robot), behind, ahead);
  window.clear();
  for (std::size_t i = range.begin; i < range.end; ++i) window.push_back(transform.apply(plan_.plan()[i]));
}

}  // namespace hidwa_local_planner
