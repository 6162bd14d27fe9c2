// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner {

/// The cost of the cell under the robot's centre at the last pose, or summed over all poses, in [0, 252] a pose.
/// Refuses candidates whose centre enters lethal, inscribed or (by policy) unknown cells or leaves the map; not where
/// the robot already stands in one and `escape` is on, or it could never leave.
class BaseObstacleCritic : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;
  void prepare(const CycleView& cycle) override;
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override;

 private:
  bool obstacle(const GridView& grid, double x, double y) const;
  void add_costs(const GridView& grid, const Tile& tile, std::size_t k, std::size_t first, std::size_t count,
                 double* sum) const;
  void add_last_costs(const CycleView& cycle, const Tile& tile, std::size_t first, std::size_t count,
                      double* sum) const;
  bool hits(const GridView& grid, const Tile& tile, std::size_t c) const;

  bool sum_scores_ = false;
  bool escape_ = true;
  bool unknown_is_obstacle_ = true;
  bool refuses_ = true;
};

}  // namespace hidwa_local_planner
