// SPDX-License-Identifier: BSD-3-Clause
#include "critics/prefer_forward.hpp"

#include <cmath>

namespace hidwa_local_planner {

double PreferForwardCritic::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  penalty_ = parameters.PreferForward_penalty;
  strafe_x_ = parameters.PreferForward_strafe_x;
  strafe_theta_ = parameters.PreferForward_strafe_theta;
  theta_scale_ = parameters.PreferForward_theta_scale;
  return parameters.PreferForward_scale;
}

void PreferForwardCritic::score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) {
  const double turn = std::abs(tile.omega);
  for (std::size_t c = 0; c < tile.count; ++c) {
    const bool creeps = tile.v[c] < strafe_x_ && turn < strafe_theta_;
    scores.set(c, tile.v[c] < 0.0 || creeps ? penalty_ : turn * theta_scale_);
  }
}

}  // namespace hidwa_local_planner
