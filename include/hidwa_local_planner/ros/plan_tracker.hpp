// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/PoseStamped.h>

#include "hidwa_local_planner/core/plan_window.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/ros/conversions.hpp"

namespace hidwa_local_planner {

/// The global plan in its own frame, and whether its goal is a new one.
class PlanTracker {
 public:
  /// Takes a plan. True when its goal is new: the last pose or the frame differs from the last usable plan's,
  /// or that goal was reached. A plan that cannot be used leaves the tracker without one; fault() says why.
  bool set(const std::vector<geometry_msgs::PoseStamped>& plan);
  /// The goal was reached: whatever plan comes next has a new goal.
  void finish() { has_goal_ = false; }

  /// Empty when there is a plan to follow, else what is wrong with it.
  const std::string& fault() const { return fault_; }
  const std::string& frame() const { return frame_; }
  const Pose2& goal() const { return goal_; }  // in the plan's frame

  /// The part of the plan from `behind` [m] behind the robot's progress to `ahead` [m] ahead of it, in the
  /// outer frame of `transform` (the costmap's), where `robot` is given too. Reuses the memory of `window`.
  void window(const FrameTransform& transform, const Pose2& robot, double behind, double ahead,
              std::vector<Pose2>& window);

 private:
  PlanWindow plan_;
  std::string frame_;
  Pose2 goal_;
  bool has_goal_ = false;
  std::string fault_ = "no plan was given yet";
};

}  // namespace hidwa_local_planner
