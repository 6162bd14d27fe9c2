// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "critics/map_grid.hpp"

namespace hidwa_local_planner {

/// How far from the plan a candidate's nose ends: it aligns the robot with the plan. Off within the nose's length of
/// the final goal.
class PathAlignCritic : public MapGridCritic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;

 protected:
  const DistanceGrid* choose(const CycleView& cycle) override;
};

}  // namespace hidwa_local_planner
