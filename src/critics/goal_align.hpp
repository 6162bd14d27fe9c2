// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "critics/map_grid.hpp"

namespace hidwa_local_planner {

/// How far a candidate's nose ends from the local goal, moved ahead by the nose's length towards the final goal.
class GoalAlignCritic : public MapGridCritic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;

 protected:
  const DistanceGrid* choose(const CycleView& cycle) override;
};

}  // namespace hidwa_local_planner
