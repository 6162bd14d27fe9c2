// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "critics/built_in_entry.hpp"
#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner::critics {
namespace {

// What drives and turns more slowly creeps. DWB's strafe_x and strafe_theta.
constexpr double kCreepX = 0.1;      // [m/s]
constexpr double kCreepTheta = 0.2;  // [rad/s]

/// Penalises driving backwards and creeping; all other candidates cost |omega| * theta_scale.
class PreferForward : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& /*own*/) override {
    penalty_ = parameters.PreferForward_penalty;
    theta_scale_ = parameters.PreferForward_theta_scale;
    return 1.0;
  }

  void score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) override {
    const double turn = std::abs(tile.omega);
    for (std::size_t c = 0; c < tile.count; ++c) {
      const bool creeps = tile.v[c] < kCreepX && turn < kCreepTheta;
      scores.set(c, tile.v[c] < 0.0 || creeps ? penalty_ : turn * theta_scale_);
    }
  }

 private:
  double penalty_ = 1.0;
  double theta_scale_ = 10.0;  // [s/rad]
};

const BuiltInEntry entry("PreferForward", make<PreferForward>);

}  // namespace
}  // namespace hidwa_local_planner::critics
