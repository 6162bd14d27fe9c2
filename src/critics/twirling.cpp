// SPDX-License-Identifier: BSD-3-Clause
#include "critics/twirling.hpp"

#include <cmath>

namespace hidwa_local_planner {

double TwirlingCritic::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  return parameters.Twirling_scale;
}

void TwirlingCritic::score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) {
  for (std::size_t c = 0; c < tile.count; ++c) scores.set(c, std::abs(tile.omega));
}

}  // namespace hidwa_local_planner
