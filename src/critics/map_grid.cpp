// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/critics/map_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hidwa_local_planner {
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

bool blocked(const GridView& grid, double x, double y) {
  const std::uint8_t value = grid.at(grid.cell_at(x, y));
  return value == cost::kLethal || value == cost::kInscribed;
}

}  // namespace

void MapGridCritic::prepare(const CycleView& cycle) {
  off_map_ = !cycle.grids->on_map();
  distances_ = off_map_ ? nullptr : choose(cycle);
  unreached_ = cycle.grid->resolution * (cycle.grid->size_x + cycle.grid->size_y);
  if (off_map_) nearest_ = nearest_pose(*cycle.plan, cycle.pose);
}

void MapGridCritic::score(const CycleView& cycle, const Tile& tile, TileScores& scores) {
  if (!off_map_ && distances_ == nullptr) return;
  const double cosine = tile.cos_heading[tile.steps];
  const double sine = tile.sin_heading[tile.steps];
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (scores.refused(c)) continue;
    const Pose2 last = tile.last_pose(c);
    if (off_map_) {
      scores.set(c, bearing_error(last, nearest_));
      continue;
    }
    const char* reason = nullptr;
    const double raw = raw_score(*cycle.grid, last, cosine, sine, &reason);
    if (reason != nullptr) {
      scores.refuse(c, reason);
    } else {
      scores.set(c, raw);
    }
  }
}

double MapGridCritic::raw_score(const GridView& grid, const Pose2& last, double cosine, double sine,
                                const char** reason) const {
  const double nose_x = last.x + forward_ * cosine;
  const double nose_y = last.y + forward_ * sine;
  const double nose = PlanGrids::at(*distances_, grid, nose_x, nose_y);
  if (distance_ == MapGridDistance::l1) {  // Nav2: every point must lie on a reached cell
    if (nose < 0.0) *reason = "trajectory leaves the map or the plan cannot be reached";
    return nose;
  }
  if (nose >= 0.0 && !blocked(grid, nose_x, nose_y)) return nose;
  const double centre = PlanGrids::at(*distances_, grid, last.x, last.y);
  return centre >= 0.0 ? centre : unreached_;
}

}  // namespace hidwa_local_planner
