// SPDX-License-Identifier: BSD-3-Clause
#include "critics/built_in_entry.hpp"
#include "critics/map_grid.hpp"

namespace hidwa_local_planner::critics {
namespace {

/// How far from the local goal, the last pose of the plan's window, a candidate ends.
class GoalDist : public MapGridCritic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;

 protected:
  std::optional<PlanDistance> choose(const CycleView& cycle) const override;
};

double GoalDist::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  paper_ = parameters.method == Method::paper;
  return 0.5 * parameters.GoalDist_scale;
}

std::optional<PlanDistance> GoalDist::choose(const CycleView& /*cycle*/) const { return PlanDistance::to_goal(); }

const BuiltInEntry entry("GoalDist", make<GoalDist>);

}  // namespace
}  // namespace hidwa_local_planner::critics
