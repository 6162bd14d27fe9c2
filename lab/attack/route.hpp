// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "random.hpp"
#include "spec.hpp"
#include "world.hpp"

namespace hidwa_attack {

/// The global plan: lines to random places, through walls too, for it may be stale. A new one now and then, and some
/// time after the goal was reached.
class Route {
 public:
  Route(const World& world, std::uint64_t seed) : world_(world), random_(seed) {}

  /// True where a new goal begins at `now` [ms].
  bool renew(int now, const Pose2& robot);
  const Pose2& goal() const { return points_.back(); }
  const std::vector<Pose2>& points() const { return points_; }  // from where the robot was
  /// The position of the goal was reached.
  bool latched() const { return latched_; }

 private:
  void lay(const Pose2& robot);
  void lead_to(const Spot& next);

  const World& world_;
  Random random_;
  std::vector<Pose2> points_;
  int until_ = 0;  // [ms]
  bool latched_ = false;
};

}  // namespace hidwa_attack
