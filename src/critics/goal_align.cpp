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
  std::optional<PlanDistance> choose(const CycleView& cycle) const override;
};

double GoalAlign::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  paper_ = parameters.method == Method::paper;
  forward_ = parameters.forward_point_distance;
  return 0.5 * parameters.GoalAlign_scale;
}

std::optional<PlanDistance> GoalAlign::choose(const CycleView& /*cycle*/) const {
  return PlanDistance::to_goal(forward_);
}

const BuiltInEntry entry("GoalAlign", make<GoalAlign>);

}  // namespace
}  // namespace hidwa_local_planner::critics
