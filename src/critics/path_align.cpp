// SPDX-License-Identifier: BSD-3-Clause
#include "critics/built_in_entry.hpp"
#include "critics/map_grid.hpp"

namespace hidwa_local_planner::critics {
namespace {

/// How far from the plan a candidate's nose ends: it aligns the robot with the plan. Off within the nose's length of
/// the final goal.
class PathAlign : public MapGridCritic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;

 protected:
  std::optional<PlanDistance> choose(const CycleView& cycle) const override;
};

double PathAlign::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  paper_ = parameters.method == Method::paper;
  forward_ = parameters.forward_point_distance;
  return 0.5 * parameters.PathAlign_scale;
}

std::optional<PlanDistance> PathAlign::choose(const CycleView& cycle) const {
  // At the goal the nose lies beyond the path's end: it would push the robot back.
  if (distance(cycle.pose, cycle.goal) <= forward_) return std::nullopt;
  return PlanDistance::to_path();
}

const BuiltInEntry entry("PathAlign", make<PathAlign>);

}  // namespace
}  // namespace hidwa_local_planner::critics
