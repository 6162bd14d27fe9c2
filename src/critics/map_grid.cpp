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

bool blocked(std::uint8_t value) { return value == cost::kLethal || value == cost::kInscribed; }

}  // namespace

void MapGridCritic::prepare(const CycleView& cycle) {
  off_map_ = !cycle.grids->on_map();
  distances_ = off_map_ ? nullptr : choose(cycle);
  cells_per_metre_ = 1.0 / cycle.grid->resolution;
  unreached_ = cycle.grid->resolution * (cycle.grid->size_x + cycle.grid->size_y);
  if (off_map_) nearest_ = nearest_pose(*cycle.plan, cycle.pose);
}

void MapGridCritic::score(const CycleView& cycle, const Tile& tile, TileScores& scores) {
  if (!off_map_ && distances_ == nullptr) return;
  const Point ahead{forward_ * tile.cos_heading[tile.steps], forward_ * tile.sin_heading[tile.steps]};
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (scores.refused(c)) continue;
    if (off_map_) {
      scores.set(c, bearing_error(tile.last_pose(c), nearest_));
      continue;
    }
    const Point last{tile.x_at(tile.steps, c), tile.y_at(tile.steps, c)};
    const char* reason = nullptr;
    const double raw = raw_score(*cycle.grid, last, last + ahead, &reason);
    if (reason != nullptr) {
      scores.refuse(c, reason);
    } else {
      scores.set(c, raw);
    }
  }
}

// A distance [m], or a negative number where there is none: off the map or unreached.
double MapGridCritic::at(const GridView& grid, Cell cell) const {
  if (!grid.contains(cell)) return -1.0;
  const std::int32_t units = distances_->units(cell);
  return units == DistanceGrid::kUnreached ? -1.0 : units * distances_->metres_per_unit();
}

double MapGridCritic::raw_score(const GridView& grid, const Point& last, const Point& nose,
                                const char** reason) const {
  const Cell cell = cell_at(grid, nose);
  if (distance_ == MapGridDistance::l1) {  // Nav2: every point must lie on a reached cell
    const double raw = at(grid, cell);
    if (raw < 0.0) *reason = "trajectory leaves the map or the plan cannot be reached";
    return raw;
  }
  // Only where the nose is on no free cell does the centre count instead.
  if (grid.contains(cell) && !blocked(grid.at(cell))) {
    const double raw = at(grid, cell);
    if (raw >= 0.0) return raw;
  }
  const double centre = at(grid, cell_at(grid, last));
  return centre >= 0.0 ? centre : unreached_;
}

}  // namespace hidwa_local_planner
