// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner {

/// Penalises turning: |omega| [rad/s].
class TwirlingCritic : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override;
};

}  // namespace hidwa_local_planner
