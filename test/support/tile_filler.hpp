// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "core/collision/cell_classes.hpp"
#include "core/collision/collision.hpp"
#include "core/distance/plan_grids.hpp"
#include "core/evaluation/tile_surroundings.hpp"
#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

/// Sets in a CycleView and in tiles made by hand what the planner sets for critics.
class TileFiller {
 public:
  /// Once a cycle; `scene` must outlive it.
  void prepare(const Scene& scene) {
    scene_ = &scene;
    grid_ = scene.grid();
    footprint_ = Footprint::from_outline(scene.outline, scene.parameters.footprint_padding);
    grids_.prepare(grid_, scene.situation.plan, scene.parameters.method, scene.parameters.unknown_is_obstacle);
    reach_ = -1.0;
    surroundings_.prepare({&grid_, &grids_, &checker_, scene.situation.pose, scene.situation.goal});
  }
  CycleView view() {
    const bool steered = scene_->intent.influence != Influence::none;
    CycleView cycle;
    cycle.pose = scene_->situation.pose;
    cycle.velocity = scene_->situation.velocity;
    cycle.last_command = scene_->situation.last_command;
    cycle.goal = scene_->situation.goal;
    cycle.time = scene_->situation.time;
    cycle.steered = steered;
    cycle.operator_decides =
        steered && (scene_->intent.influence == Influence::direct || scene_->situation.goal_latched);
    cycle.plan = &scene_->situation.plan;
    cycle.grid = &grid_;
    cycle.footprint = &footprint_;
    cycle.moving_obstacles = &scene_->situation.moving_obstacles;
    cycle.surroundings = &surroundings_;
    return cycle;
  }
  /// Of a tile that has its poses. Valid until the next call.
  void fill(Tile& tile) {
    const Pose2 start = tile.pose(0, 0);
    double reach = 0.0;
    for (std::size_t k = 1; k <= tile.steps; ++k) {
      for (std::size_t c = 0; c < tile.count; ++c) reach = std::max(reach, distance(start, tile.pose(k, c)));
    }
    if (reach > reach_ || distance(start, centre_) > 0.0) look_around(start, 1.5 * reach + 0.5);
    tile.cells = classes_.under(checker_, tile);
    tile.surroundings = &surroundings_;
  }

 private:
  void look_around(const Pose2& centre, double reach) {
    const bool unknown = scene_->parameters.unknown_is_obstacle;
    checker_.prepare(grid_, footprint_, unknown, centre, reach, grid_.resolution, 2.0 * grid_.resolution);
    centre_ = centre;
    reach_ = reach;
  }

  const Scene* scene_ = nullptr;
  GridView grid_;
  Footprint footprint_;
  PlanGrids grids_;
  CollisionChecker checker_;
  CellClasses classes_;
  TileSurroundings surroundings_;
  Pose2 centre_;         // of what was looked at last
  double reach_ = -1.0;  // around it [m]; negative: nothing yet
};

}  // namespace hidwa_local_planner::test
