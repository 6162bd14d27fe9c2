// SPDX-License-Identifier: BSD-3-Clause
#include "critics/rotate_to_goal.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

// A sample slower than this does not drive [m/s].
constexpr double kStill = 1e-5;

}  // namespace

double RotateToGoalCritic::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  xy_goal_tolerance_ = parameters.xy_goal_tolerance;
  trans_stopped_velocity_ = parameters.trans_stopped_velocity;
  slowing_factor_ = parameters.RotateToGoal_slowing_factor;
  lookahead_time_ = parameters.RotateToGoal_lookahead_time;
  return parameters.RotateToGoal_scale;
}

void RotateToGoalCritic::prepare(const CycleView& cycle) {
  if (distance(cycle.pose, cycle.goal) <= xy_goal_tolerance_) in_window_ = true;
  if (in_window_ && std::abs(cycle.velocity.v) <= trans_stopped_velocity_) rotating_ = true;
  speed2_ = cycle.velocity.v * cycle.velocity.v;
  refuses_ = !cycle.steered;
}

double RotateToGoalCritic::heading_error(const Tile& tile, double goal_heading) const {
  double heading = tile.heading[tile.steps];
  if (lookahead_time_ >= 0.0) {
    const double at = std::min(lookahead_time_ / tile.dt, static_cast<double>(tile.steps));
    const auto k = std::min(static_cast<std::size_t>(at), tile.steps - 1);
    heading = tile.heading[k] + (at - static_cast<double>(k)) * (tile.heading[k + 1] - tile.heading[k]);
  }
  return std::abs(wrap_angle(goal_heading - heading));
}

void RotateToGoalCritic::score(const CycleView& cycle, const Tile& tile, TileScores& scores) {
  if (!in_window_) return;
  const double error = heading_error(tile, cycle.goal.theta);
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (scores.refused(c)) continue;
    const double speed2 = tile.v[c] * tile.v[c];
    if (refuses_ && rotating_ && std::abs(tile.v[c]) > kStill) {
      scores.refuse(c, "drives on although the goal's position is reached");
    } else if (refuses_ && !rotating_ && speed2 >= speed2_) {
      scores.refuse(c, "does not slow down at the goal");
    } else {
      scores.set(c, rotating_ ? error : speed2 * slowing_factor_ + error);
    }
  }
}

void RotateToGoalCritic::reset() { in_window_ = rotating_ = false; }

}  // namespace hidwa_local_planner
