// SPDX-License-Identifier: BSD-3-Clause
#include "critics/goal_align.hpp"

namespace hidwa_local_planner {

double GoalAlignCritic::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  distance_ = parameters.map_grid;
  forward_ = parameters.GoalAlign_forward_point_distance;
  return 0.5 * parameters.GoalAlign_scale;
}

const DistanceGrid* GoalAlignCritic::choose(const CycleView& cycle) {
  return &cycle.grids->to_goal_ahead(forward_, cycle.pose, cycle.goal);
}

}  // namespace hidwa_local_planner
