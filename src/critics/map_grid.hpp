// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner::critics {

/// What the four map-grid critics share: the raw score is the distance [m] of a point `forward` ahead of the last pose
/// to the plan or the local goal; it weighs scale/2 per metre, as Nav2's resolution * scale / 2 per cell.
/// Where no pose of the plan lies on the map, the score is how far the last pose's heading is off the bearing to the
/// nearest plan pose [rad], so that a steered robot can be led back.
/// `method: paper` rejects candidates whose point has no way to the plan, as Nav2 does, unless the person decides.
class MapGridCritic : public Critic {
 public:
  double reach() const final { return forward_; }
  void prepare(const CycleView& cycle) final;
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) final;

 protected:
  /// Which distance counts in this cycle; none turns the critic off for this cycle.
  virtual std::optional<PlanDistance> choose(const CycleView& cycle) const = 0;

  bool paper_ = false;    // method: paper
  double forward_ = 0.0;  // the point's distance ahead of the robot [m]

 private:
  void score_bearings(const Tile& tile, TileScores& scores) const;
  void score_unreached(const Tile& tile, double* raw, TileScores& scores) const;

  std::optional<PlanDistance> chosen_;
  bool off_map_ = false;
  bool rejects_ = false;    // what has no way to the plan
  Pose2 nearest_;           // the plan's pose nearest to the robot, when it is off the map
  double unreached_ = 0.0;  // the score where there is no way [m]
};

}  // namespace hidwa_local_planner::critics
