// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "critics/built_in_entry.hpp"
#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner::critics {
namespace {

/// Penalises turning: |omega| [rad/s].
class Twirling : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& /*own*/) override {
    return parameters.Twirling_scale;
  }

  void score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) override {
    for (std::size_t c = 0; c < tile.count; ++c) scores.set(c, std::abs(tile.omega));
  }
};

const BuiltInEntry entry("Twirling", make<Twirling>);

}  // namespace
}  // namespace hidwa_local_planner::critics
