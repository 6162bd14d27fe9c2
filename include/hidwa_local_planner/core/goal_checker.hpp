// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Goal reached: within the position tolerance once (latched until reset), within the heading tolerance, and stopped.
class GoalChecker {
 public:
  void reset() { latched_ = false; }
  /// Updates the latch; poses in one frame. True when the goal is reached.
  bool update(const Pose2& robot, const Twist2& velocity, const Pose2& goal, const Parameters& parameters);
  bool latched() const { return latched_; }

 private:
  bool latched_ = false;
};

}  // namespace hidwa_local_planner
