// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <pluginlib/class_list_macros.hpp>

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_example_critics {

using hidwa_local_planner::CycleView;
using hidwa_local_planner::Parameters;
using hidwa_local_planner::ParameterSource;
using hidwa_local_planner::Tile;
using hidwa_local_planner::TileScores;

/// Rejects turns faster than `limit` [rad/s], and makes the others cost `scale` x |omega|.
class TurnLimit : public hidwa_local_planner::Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override {
    limit_ = own.number("limit", parameters.max_vel_theta);
    return own.number("scale", 1.0);
  }

  void score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) override {
    for (std::size_t c = 0; c < scores.count(); ++c) {
      if (std::abs(tile.omega) > limit_) {
        scores.reject(c, "turns too fast");
      } else {
        scores.set(c, std::abs(tile.omega));
      }
    }
  }

 private:
  double limit_ = 0.0;  // [rad/s]
};

}  // namespace hidwa_example_critics

PLUGINLIB_EXPORT_CLASS(hidwa_example_critics::TurnLimit, hidwa_local_planner::Critic)
