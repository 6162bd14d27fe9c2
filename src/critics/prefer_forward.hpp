// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner {

/// Penalises driving backwards and creeping (neither driving nor turning faster than the strafe thresholds); all other
/// candidates cost |omega| * theta_scale.
class PreferForwardCritic : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override;

 private:
  double penalty_ = 1.0;
  double strafe_x_ = 0.1;      // [m/s]
  double strafe_theta_ = 0.2;  // [rad/s]
  double theta_scale_ = 10.0;  // [s/rad]
};

}  // namespace hidwa_local_planner
