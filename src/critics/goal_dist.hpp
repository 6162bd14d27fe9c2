// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "critics/map_grid.hpp"

namespace hidwa_local_planner {

/// How far from the local goal, the last pose of the plan's window, a candidate ends.
class GoalDistCritic : public MapGridCritic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;

 protected:
  const DistanceGrid* choose(const CycleView& cycle) override;
};

}  // namespace hidwa_local_planner
