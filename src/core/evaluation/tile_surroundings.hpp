// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/collision/collision.hpp"
#include "core/distance/distance_grid.hpp"
#include "core/distance/plan_grids.hpp"
#include "hidwa_local_planner/core/surroundings.hpp"
#include "hidwa_local_planner/core/tile.hpp"

namespace hidwa_local_planner {

/// Answers the critics' questions from the distance grids, the costs and the collision checker of a cycle.
class TileSurroundings final : public Surroundings {
 public:
  /// All of it outlives the cycle.
  struct Cycle {
    const GridView* grid = nullptr;
    PlanGrids* grids = nullptr;                 // prepared
    const CollisionChecker* checker = nullptr;  // prepared
    Pose2 pose;                                 // of the robot
    Pose2 goal;  // the last pose of the full plan, or of a window that ends where the plan turns back
  };
  /// Once per evaluation.
  void prepare(const Cycle& cycle) { cycle_ = cycle; }

  bool plan_on_map() const override { return cycle_.grids->on_map(); }
  void expect(const PlanDistance& distance) override { grid_of(distance); }
  bool distances(const Tile& tile, const PlanDistance& distance, double forward, const TileScores& scores,
                 double* found) override;
  void costs(const Tile& tile, std::size_t step, double* found) override;
  void clearances(const Tile& tile, std::size_t step, double* found) override;

 private:
  DistanceGrid grid_of(const PlanDistance& distance);
  void find_cells(const Tile& tile, std::size_t step, double dx, double dy);

  Cycle cycle_;
  std::vector<std::int32_t> i_, j_;  // cells of the tile's candidates
};

}  // namespace hidwa_local_planner
