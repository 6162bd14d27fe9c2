// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include <pluginlib/class_list_macros.hpp>

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_broken_critics {

using hidwa_local_planner::CycleView;
using hidwa_local_planner::Parameters;
using hidwa_local_planner::ParameterSource;
using hidwa_local_planner::Tile;
using hidwa_local_planner::TileScores;

class CannotBeMade : public hidwa_local_planner::Critic {
 public:
  CannotBeMade() { throw std::runtime_error("no memory of its own"); }
  double configure(const Parameters& /*parameters*/, const ParameterSource& /*own*/) override { return 1.0; }
  void score(const CycleView& /*cycle*/, const Tile& /*tile*/, TileScores& /*scores*/) override {}
};

class CannotBeConfigured : public hidwa_local_planner::Critic {
 public:
  double configure(const Parameters& /*parameters*/, const ParameterSource& /*own*/) override {
    throw std::runtime_error("its table is missing");
  }
  void score(const CycleView& /*cycle*/, const Tile& /*tile*/, TileScores& /*scores*/) override {}
};

}  // namespace hidwa_broken_critics

PLUGINLIB_EXPORT_CLASS(hidwa_broken_critics::CannotBeMade, hidwa_local_planner::Critic)
PLUGINLIB_EXPORT_CLASS(hidwa_broken_critics::CannotBeConfigured, hidwa_local_planner::Critic)
