// SPDX-License-Identifier: BSD-3-Clause
#include "critics/map_grid.hpp"

#include <cmath>
#include <limits>

namespace hidwa_local_planner::critics {
namespace {

Pose2 nearest_pose(const std::vector<Pose2>& plan, const Pose2& robot) {
  Pose2 nearest = robot;
  double best = std::numeric_limits<double>::infinity();
  for (const Pose2& pose : plan) {
    const double away = distance(pose, robot);
    if (away < best) {
      best = away;
      nearest = pose;
    }
  }
  return nearest;
}

double bearing_error(const Pose2& pose, const Pose2& target) {
  return std::abs(wrap_angle(std::atan2(target.y - pose.y, target.x - pose.x) - pose.theta));
}

}  // namespace

void MapGridCritic::prepare(const CycleView& cycle) {
  off_map_ = !cycle.plan_on_map();
  rejects_ = paper_ && !cycle.operator_decides;
  chosen_ = choose(cycle);
  unreached_ = cycle.grid->resolution * (cycle.grid->size_x + cycle.grid->size_y);
  if (off_map_) {
    nearest_ = nearest_pose(*cycle.plan, cycle.pose);
  } else if (chosen_) {
    cycle.expect(*chosen_);
  }
}

void MapGridCritic::score(const CycleView& /*cycle*/, const Tile& tile, TileScores& scores) {
  if (off_map_) return score_bearings(tile, scores);
  if (!chosen_) return;
  double* raw = scores.set_all();
  if (!tile.distances(*chosen_, forward_, scores, raw)) score_unreached(tile, raw, scores);
}

void MapGridCritic::score_bearings(const Tile& tile, TileScores& scores) const {
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (!scores.rejected(c)) scores.set(c, bearing_error(tile.last_pose(c), nearest_));
  }
}

// Where the distance is negative: there is no way, or the candidate is rejected already and nothing was measured.
void MapGridCritic::score_unreached(const Tile& tile, double* raw, TileScores& scores) const {
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (raw[c] >= 0.0) continue;
    if (!scores.rejected(c) && rejects_) scores.reject(c, "trajectory leaves the map or the plan cannot be reached");
    raw[c] = scores.rejected(c) ? 0.0 : unreached_;
  }
}

}  // namespace hidwa_local_planner::critics
