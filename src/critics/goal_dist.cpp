// SPDX-License-Identifier: BSD-3-Clause
#include "critics/goal_dist.hpp"

namespace hidwa_local_planner {

double GoalDistCritic::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  distance_ = parameters.map_grid;
  return 0.5 * parameters.GoalDist_scale;
}

const DistanceGrid* GoalDistCritic::choose(const CycleView& cycle) { return &cycle.grids->to_goal(); }

}  // namespace hidwa_local_planner
