// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/critics/map_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hidwa_local_planner/core/cell_index.hpp"

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
  unreached_ = cycle.grid->resolution * (cycle.grid->size_x + cycle.grid->size_y);
  if (off_map_) nearest_ = nearest_pose(*cycle.plan, cycle.pose);
}

void MapGridCritic::score(const CycleView& cycle, const Tile& tile, TileScores& scores) {
  if (off_map_) {
    score_bearings(tile, scores);
  } else if (distances_ != nullptr) {
    for (std::size_t first = 0; first < tile.count; first += kernel::kMostPoints) {
      score_some(cycle, tile, first, std::min(kernel::kMostPoints, tile.count - first), scores);
    }
  }
}

void MapGridCritic::score_bearings(const Tile& tile, TileScores& scores) const {
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (!scores.refused(c)) scores.set(c, bearing_error(tile.last_pose(c), nearest_));
  }
}

void MapGridCritic::score_some(const CycleView& cycle, const Tile& tile, std::size_t first, std::size_t count,
                               TileScores& scores) const {
  const double ahead_x = forward_ * tile.cos_heading[tile.steps], ahead_y = forward_ * tile.sin_heading[tile.steps];
  const std::size_t row = tile.steps * tile.stride + first;
  const DistanceGrids::Table table = distances_->table();
  const double metres_per_unit = distances_->metres_per_unit();
  std::int32_t i[kernel::kMostPoints], j[kernel::kMostPoints];
  std::size_t hard[kernel::kMostPoints], hard_count = 0;
  kernel::find_cells(*cycle.grid, table.box, tile.x + row, tile.y + row, ahead_x, ahead_y, count, i, j);
  for (std::size_t c = 0; c < count; ++c) {
    if (scores.refused(first + c)) continue;
    const std::int32_t units = i[c] >= 0 ? table.free_units(i[c], j[c]) : DistanceGrids::kUnreached;
    if (units >= 0) {
      scores.set(first + c, units * metres_per_unit);
    } else {
      hard[hard_count++] = c;
    }
  }
  for (std::size_t h = 0; h < hard_count; ++h) {
    const std::size_t c = first + hard[h];
    const char* reason = nullptr;
    const Pose2 last = tile.last_pose(c);
    const double raw = raw_score(*cycle.grid, last, last.x + ahead_x, last.y + ahead_y, &reason);
    if (reason != nullptr) {
      scores.refuse(c, reason);
    } else {
      scores.set(c, raw);
    }
  }
}

double MapGridCritic::raw_score(const GridView& grid, const Pose2& last, double nose_x, double nose_y,
                                const char** reason) const {
  const Cell nose = grid.cell_at(nose_x, nose_y);
  if (distance_ == MapGridDistance::l1) {  // Nav2: every point must lie on a reached cell
    const double raw = PlanGrids::at(*distances_, grid, nose_x, nose_y);
    if (raw < 0.0) *reason = "trajectory leaves the map or the plan cannot be reached";
    return raw;
  }
  if (grid.contains(nose) && !blocked(grid.at(nose))) {
    const double raw = PlanGrids::at(*distances_, grid, nose_x, nose_y);
    if (raw >= 0.0) return raw;
  }
  // Where the nose is on no free cell with a way to the plan, the centre counts instead.
  const double centre = PlanGrids::at(*distances_, grid, last.x, last.y);
  return centre >= 0.0 ? centre : unreached_;
}

}  // namespace hidwa_local_planner
