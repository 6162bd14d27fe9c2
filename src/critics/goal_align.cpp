// SPDX-License-Identifier: BSD-3-Clause
#include "critics/built_in_entry.hpp"
#include "critics/map_grid.hpp"

namespace hidwa_local_planner::critics {
namespace {

/// How far a candidate's nose ends from the local goal, moved ahead by the nose's length towards the final goal.
class GoalAlign : public MapGridCritic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;

 protected:
  const DistanceGrid* choose(const CycleView& cycle) override;
};

double GoalAlign::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  distance_ = parameters.map_grid;
  forward_ = parameters.GoalAlign_forward_point_distance;
  return 0.5 * parameters.GoalAlign_scale;
}

const DistanceGrid* GoalAlign::choose(const CycleView& cycle) {
  return &cycle.grids->to_goal_ahead(forward_, cycle.pose, cycle.goal);
}

const BuiltInEntry entry("GoalAlign", make<GoalAlign>);

}  // namespace
}  // namespace hidwa_local_planner::critics
