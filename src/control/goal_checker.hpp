// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// Goal reached: within the position tolerance once (latched while the robot stays about there), within the heading
/// tolerance, and stopped. It depends only on the pose that it is given.
class GoalChecker {
 public:
  void reset() { latched_ = false; }
  /// A control cycle at `now` [s].
  void cycle(double now) { last_cycle_ = now; }
  /// A plan came at `now` [s]. True after a pause of the cycles at `period` [s] (is_pause), or where time went back.
  /// Then another node may have moved the robot, and the latch is forgotten.
  bool plan_arrives(double now, double period);
  /// Updates the latch, which ends beyond the tolerance plus goal_margin(); poses in one frame. True when the goal is
  /// reached. `next`: no other part of the plan is to be driven first; before, nothing is latched.
  bool update(const Pose2& robot, const Twist2& velocity, const Pose2& goal, const Parameters& parameters,
              bool next = true);
  bool latched() const { return latched_; }
  const std::optional<double>& last_cycle() const { return last_cycle_; }  // when it was [s]
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.latched_, self.last_cycle_);
  }

 private:
  bool latched_ = false;
  std::optional<double> last_cycle_;  // [s]
};

/// How far beyond xy_goal_tolerance a latch lasts [m]: as much again, for the drift while the robot turns to its
/// heading, within 0.05 m (jitter of a pose) and 0.25 m.
double goal_margin(const Parameters& parameters);

}  // namespace hidwa_local_planner
