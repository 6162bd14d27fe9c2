// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_2d_ros.h>
#include <geometry_msgs/PoseStamped.h>

#include <string>
#include <vector>

namespace nav_core {

/// What move_base asks of a global planner.
class BaseGlobalPlanner {
 public:
  virtual ~BaseGlobalPlanner() = default;

  virtual void initialize(std::string name, costmap_2d::Costmap2DROS* costmap_ros) = 0;

  /// A plan from `start` to `goal`, both in the costmap's global frame; false when there is none.
  virtual bool makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                        std::vector<geometry_msgs::PoseStamped>& plan) = 0;

  /// The same, with the plan's cost where the planner knows one, else 0.
  virtual bool makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                        std::vector<geometry_msgs::PoseStamped>& plan, double& cost) {
    cost = 0.0;
    return makePlan(start, goal, plan);
  }

 protected:
  BaseGlobalPlanner() = default;
};

}  // namespace nav_core
