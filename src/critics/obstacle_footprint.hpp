// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/critic.hpp"
#include "hidwa_local_planner/core/footprint.hpp"

namespace hidwa_local_planner {

/// The largest cost under the footprint's outline at the last pose, or summed over all poses. Refuses candidates whose
/// outline touches a lethal or (by policy) unknown cell or leaves the map; not where it already does and `escape` is
/// on.
class ObstacleFootprintCritic : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;
  void prepare(const CycleView& cycle) override;
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override;

 private:
  /// The largest cost under the outline at a pose; negative where it touches an obstacle.
  double outline_cost(const GridView& grid, double x, double y, double cosine, double sine) const;

  bool sum_scores_ = false;
  bool escape_ = true;
  bool unknown_is_obstacle_ = true;
  bool refuses_ = true;
  Polygon outline_;  // points of the outline at most half a cell apart, robot frame [m]
};

}  // namespace hidwa_local_planner
