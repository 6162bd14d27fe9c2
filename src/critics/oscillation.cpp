// SPDX-License-Identifier: BSD-3-Clause
#include "critics/oscillation.hpp"

#include <cmath>

namespace hidwa_local_planner {

double OscillationCritic::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  x_only_threshold_ = parameters.Oscillation_x_only_threshold;
  reset_dist_ = parameters.Oscillation_reset_dist;
  reset_angle_ = parameters.Oscillation_reset_angle;
  reset_time_ = parameters.Oscillation_reset_time;
  while_steering_ = parameters.oscillation_while_steering;
  return parameters.Oscillation_scale;
}

void OscillationCritic::prepare(const CycleView& cycle) {
  silent_ = cycle.person_decides || (cycle.steered && !while_steering_);
}

void OscillationCritic::score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) {
  if (silent_ || (x_.only == 0 && theta_.only == 0)) return;
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (!scores.refused(c) && (x_.bans(tile.v[c]) || theta_.bans(tile.omega))) {
      scores.refuse(c, "goes back and forth");
    }
  }
}

bool OscillationCritic::Axis::note(double velocity) {
  const int sign = velocity > 0.0 ? 1 : velocity < 0.0 ? -1 : 0;
  const bool changed = sign != 0 && last_sign != 0 && sign != last_sign;
  if (changed) only = sign;
  if (sign != 0) last_sign = sign;
  return changed;
}

void OscillationCritic::debrief(const CycleView& cycle, const Twist2& command) {
  bool changed = x_.note(command.v);
  if (std::abs(command.v) <= x_only_threshold_ && theta_.note(command.omega)) changed = true;
  if (changed) {
    since_pose_ = cycle.pose;
    since_time_ = cycle.time;
  }
  if ((x_.only != 0 || theta_.only != 0) && may_forget(cycle)) reset();
}

bool OscillationCritic::may_forget(const CycleView& cycle) const {
  if (reset_dist_ > 0.0 && distance(cycle.pose, since_pose_) > reset_dist_) return true;
  if (reset_angle_ > 0.0 && std::abs(wrap_angle(cycle.pose.theta - since_pose_.theta)) > reset_angle_) return true;
  return reset_time_ >= 0.0 && cycle.time - since_time_ > reset_time_;
}

void OscillationCritic::reset() { x_ = theta_ = Axis{}; }

}  // namespace hidwa_local_planner
