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
  const double* x = tile.x + tile.steps * tile.stride + first;
  const double* y = tile.y + tile.steps * tile.stride + first;
  DistanceGrids::Table table = distances_->table();
  const double metres_per_unit = distances_->metres_per_unit();
  std::int32_t nose[kernel::kMostPoints];
  kernel::index_cells(*cycle.grid, {cycle.grid->size_x + 2, 1, 0}, x, y, ahead_x, ahead_y, count, nose);
  for (std::size_t c = 0; c < count; ++c) {
    if (scores.refused(first + c)) continue;
    const std::size_t at = DistanceGrids::Table::kStep * static_cast<std::size_t>(nose[c]);
    if (table.units[at] < DistanceSweep::kFar && table.mask[at] == table.open) {
      scores.set(first + c, table.units[at] * metres_per_unit);
    } else if (distance_ == MapGridDistance::l1) {  // Nav2: every point must lie on a reached cell
      scores.refuse(first + c, "trajectory leaves the map or the plan cannot be reached");
    } else {
      scores.set(first + c, without_nose(cycle, tile.last_pose(first + c)));
      table = distances_->table();  // now the blocked cells may be known
    }
  }
}

// Where the nose is on no free cell with a way to the plan, the centre counts instead.
double MapGridCritic::without_nose(const CycleView& cycle, const Pose2& last) const {
  const double centre = PlanGrids::at(*distances_, *cycle.grid, last.x, last.y);
  return centre >= 0.0 ? centre : unreached_;
}

}  // namespace hidwa_local_planner
