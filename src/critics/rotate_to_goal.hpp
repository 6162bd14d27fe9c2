// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/critic.hpp"

namespace hidwa_local_planner {

/// Turns the robot to the goal's heading once it is there. Outside the position tolerance it scores 0. Inside, latched
/// until a new goal: while still driving it refuses what does not slow down and scores speed^2 * slowing_factor plus
/// the heading error; once stopped, also latched, it refuses driving and scores the heading error [rad]. While the
/// person steers it scores likewise and refuses nothing.
class RotateToGoalCritic : public Critic {
 public:
  double configure(const Parameters& parameters, const ParameterSource& own) override;
  void prepare(const CycleView& cycle) override;
  void score(const CycleView& cycle, const Tile& tile, TileScores& scores) override;
  void reset() override;
  void save(ArchiveWriter& state) const override { state(in_window_, rotating_); }
  void load(ArchiveReader& state) override { state(in_window_, rotating_); }

 private:
  double heading_error(const Tile& tile, double goal_heading) const;

  double xy_goal_tolerance_ = 0.25;      // [m]
  double trans_stopped_velocity_ = 0.1;  // [m/s]
  double slowing_factor_ = 5.0;          // [rad s^2/m^2]
  double lookahead_time_ = -1.0;         // [s]; negative: the end of the rollout
  bool in_window_ = false;
  bool rotating_ = false;
  bool refuses_ = true;
  double speed2_ = 0.0;  // squared current speed [m^2/s^2]
};

}  // namespace hidwa_local_planner
