// SPDX-License-Identifier: BSD-3-Clause
#include "critics/built_in_entry.hpp"
#include "critics/map_grid.hpp"

namespace hidwa_local_planner::critics {
namespace {

/// How far from the plan a candidate ends.
class PathDist : public MapGridCritic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;

 protected:
  std::optional<PlanDistance> choose(const CycleView& cycle) const override;
};

double PathDist::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  paper_ = parameters.method == Method::paper;
  return 0.5 * parameters.PathDist_scale;
}

std::optional<PlanDistance> PathDist::choose(const CycleView& /*cycle*/) const { return PlanDistance::to_path(); }

const BuiltInEntry entry("PathDist", make<PathDist>);

}  // namespace
}  // namespace hidwa_local_planner::critics
