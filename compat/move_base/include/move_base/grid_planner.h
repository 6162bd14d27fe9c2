// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <costmap_2d/costmap_2d_ros.h>
#include <move_base/grid_route.h>
#include <nav_core/base_global_planner.h>
#include <ros/ros.h>

#include <string>
#include <vector>

namespace move_base {

/// The global planner of this move_base, under whichever name of the stack's planners was asked for.
/// Parameters below ~/`name`: allow_unknown (true), default_tolerance (0 m); publishes ~/`name`/plan.
class GridPlanner : public nav_core::BaseGlobalPlanner {
 public:
  void initialize(std::string name, costmap_2d::Costmap2DROS* costmap_ros) override;

  using nav_core::BaseGlobalPlanner::makePlan;
  bool makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                std::vector<geometry_msgs::PoseStamped>& plan) override;

  /// The same; where the goal's cell cannot be reached the plan ends at the reachable cell nearest to it, if
  /// one lies within `tolerance` [m].
  bool makePlan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                double tolerance, std::vector<geometry_msgs::PoseStamped>& plan);

 private:
  bool inCostmapFrame(const geometry_msgs::PoseStamped& pose, const char* what) const;
  void publish(const std::vector<geometry_msgs::PoseStamped>& plan);

  costmap_2d::Costmap2DROS* costmap_ros_ = nullptr;
  GridRoute route_;
  bool allow_unknown_ = true;
  double default_tolerance_ = 0.0;  // [m]
  ros::Publisher publisher_;
};

/// Stamped poses along a route in world coordinates: each looks along the route, the last one is `goal`'s
/// orientation.
std::vector<geometry_msgs::PoseStamped> posesAlong(const std::vector<geometry_msgs::Point>& points,
                                                   const geometry_msgs::PoseStamped& goal);

}  // namespace move_base
