// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/distance/end_cells.hpp"
#include "core/distance/plan_grids.hpp"
#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner::critics {

/// What the four map-grid critics share: the raw score is the distance [m] of a point `forward` ahead of the last pose
/// to the plan or the local goal; it weighs scale/2 per metre, as Nav2's resolution * scale / 2 per cell.
/// Where no pose of the plan lies on the map, the score is how far the last pose's heading is off the bearing to the
/// nearest plan pose [rad], so that a steered robot can be led back.
/// `map_grid: l1` refuses candidates whose point has no way to the plan, as Nav2 does, unless the person decides.
class MapGridCritic : public Critic {
 public:
  void prepare(const CycleView& cycle) final;
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) final;

 protected:
  /// The grid to look distances up in; nullptr turns the critic off for this cycle.
  virtual const DistanceGrid* choose(const CycleView& cycle) = 0;

  MapGridDistance distance_ = MapGridDistance::geodesic;
  double forward_ = 0.0;  // the point's distance ahead of the robot [m]

 private:
  void score_bearings(const Tile& tile, TileScores& scores) const;
  void score_some(const CycleView& cycle, const Tile& tile, EndCells& ends, std::size_t first,
                  TileScores& scores) const;
  void ask_centres(const CycleView& cycle, const Tile& tile, EndCells& ends, std::size_t first, std::size_t count,
                   double* raw) const;
  void score_hard(const CycleView& cycle, const Tile& tile, std::size_t c, TileScores& scores) const;
  double raw_score(const GridView& grid, const Pose2& last, double nose_x, double nose_y, const char** reason) const;

  const DistanceGrid* distances_ = nullptr;
  EndCells ends_;  // for tiles that bring none
  bool off_map_ = false;
  bool refuses_ = false;    // what has no way to the plan
  Pose2 nearest_;           // the plan's pose nearest to the robot, when it is off the map
  double unreached_ = 0.0;  // the score where there is no way [m]
};

}  // namespace hidwa_local_planner::critics
