// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/distance/distance_grid.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The distance grids of one cycle, shared by all critics and made when the first distance is asked for: to the plan's
/// window, to its local goal, and to the local goal moved ahead.
class PlanGrids {
 public:
  PlanGrids();
  /// Once per evaluation; `method` says how distances are measured; `grid` and `plan` must outlive the cycle.
  void prepare(const GridView& grid, const std::vector<Pose2>& plan, Method method, bool unknown_is_obstacle);

  /// Around obstacles, or as Nav2's map grids.
  MapGridDistance measures() const { return distances_.measures(); }

  /// False when no pose of the plan lies on the map: the grids then cannot be made.
  bool on_map() const { return !path_cells_.empty(); }

  /// Distance to the nearest cell of the plan's first stretch on the map.
  DistanceGrid to_path() { return {distances_, kPath}; }
  /// Distance to the last cell of that stretch: the local goal.
  DistanceGrid to_goal() { return {distances_, kGoal}; }
  /// Distance to the local goal after the plan's last pose was moved by `ahead` [m] along the bearing `from` -> `goal`,
  /// which are the same in a cycle. Two different `ahead` are kept: more of them are made anew whenever they are asked
  /// for.
  DistanceGrid to_goal_ahead(double ahead, const Pose2& from, const Pose2& goal);

  /// The distance at a point [m], or a negative number where there is none: off the map or unreached.
  static double at(const DistanceGrid& distances, const GridView& grid, double x, double y);

 private:
  enum Set { kPath = 0, kGoal = 1, kGoalAhead = 2 };
  static constexpr std::size_t kMostAhead = 2;  // sets from kGoalAhead on

  void find_cells_on_map(const std::vector<Pose2>& plan, std::vector<Cell>& cells) const;

  GridView grid_;
  const std::vector<Pose2>* plan_ = nullptr;
  bool stops_at_unknown_ = false;
  std::vector<Cell> path_cells_, moved_cells_, last_cell_;
  std::vector<Pose2> moved_plan_;
  DistanceGrids distances_;
  std::array<double, kMostAhead> ahead_{};  // how far each was moved [m]
  std::size_t known_ahead_ = 0;
};

}  // namespace hidwa_local_planner
