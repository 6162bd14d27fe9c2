// SPDX-License-Identifier: BSD-3-Clause
#include "critics/map_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/distance/cell_index.hpp"

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

bool blocked(std::uint8_t value) { return value == cost::kLethal || value == cost::kInscribed; }

}  // namespace

void MapGridCritic::prepare(const CycleView& cycle) {
  off_map_ = !cycle.grids->on_map();
  refuses_ = distance_ == MapGridDistance::l1 && !cycle.person_decides;
  distances_ = off_map_ ? nullptr : choose(cycle);
  unreached_ = cycle.grid->resolution * (cycle.grid->size_x + cycle.grid->size_y);
  if (off_map_) nearest_ = nearest_pose(*cycle.plan, cycle.pose);
}

void MapGridCritic::score(const CycleView& cycle, const Tile& tile, TileScores& scores) {
  if (off_map_) {
    score_bearings(tile, scores);
  } else if (distances_ != nullptr) {
    ends_.forget();
    EndCells& ends = tile.ends != nullptr ? *tile.ends : ends_;
    for (std::size_t first = 0; first < tile.count; first += kernel::kMostPoints) {
      score_some(cycle, tile, ends, first, scores);
    }
  }
}

void MapGridCritic::score_bearings(const Tile& tile, TileScores& scores) const {
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (!scores.refused(c)) scores.set(c, bearing_error(tile.last_pose(c), nearest_));
  }
}

void MapGridCritic::score_some(const CycleView& cycle, const Tile& tile, EndCells& ends, std::size_t first,
                               TileScores& scores) const {
  const DistanceGrids::Table table = distances_->table();
  const EndCells::Cells noses = ends.of(*cycle.grid, table.box, tile, forward_);
  const std::size_t count = std::min(kernel::kMostPoints, tile.count - first);
  double* raw = scores.set_all() + first;
  const double metres = distances_->metres_per_unit();
  if (table.free_distances(noses.i + first, noses.j + first, count, metres, raw)) return;
  if (distance_ == MapGridDistance::geodesic) ask_centres(cycle, tile, ends, first, count, raw);
  for (std::size_t c = 0; c < count; ++c) {
    if (raw[c] < 0.0) score_hard(cycle, tile, first + c, scores);
  }
}

// Where the nose is on a blocked cell the centre counts, see raw_score().
void MapGridCritic::ask_centres(const CycleView& cycle, const Tile& tile, EndCells& ends, std::size_t first,
                                std::size_t count, double* raw) const {
  const DistanceGrids::Table table = distances_->table();
  double of_centres[kernel::kMostPoints];
  const EndCells::Cells centres = ends.of(*cycle.grid, table.box, tile, 0.0);
  table.free_distances(centres.i + first, centres.j + first, count, distances_->metres_per_unit(), of_centres);
  const EndCells::Cells noses = ends.of(*cycle.grid, table.box, tile, forward_);
  for (std::size_t c = 0; c < count; ++c) {
    const Cell nose{noses.i[first + c], noses.j[first + c]};
    if (raw[c] >= 0.0 || nose.i < 0) continue;
    if (blocked(cycle.grid->at({table.box.i + nose.i, table.box.j + nose.j}))) raw[c] = of_centres[c];
  }
}

// Where the table does not tell.
void MapGridCritic::score_hard(const CycleView& cycle, const Tile& tile, std::size_t c, TileScores& scores) const {
  if (scores.refused(c)) {
    scores.set(c, 0.0);
    return;
  }
  const char* reason = nullptr;
  const Pose2 last = tile.last_pose(c);
  const double raw = raw_score(*cycle.grid, last, last.x + forward_ * tile.cos_heading[tile.steps],
                               last.y + forward_ * tile.sin_heading[tile.steps], &reason);
  if (reason != nullptr) {
    scores.set(c, 0.0);
    scores.refuse(c, reason);
  } else {
    scores.set(c, raw);
  }
}

double MapGridCritic::raw_score(const GridView& grid, const Pose2& last, double nose_x, double nose_y,
                                const char** reason) const {
  const Cell nose = grid.cell_at(nose_x, nose_y);
  if (distance_ == MapGridDistance::l1) {  // Nav2: every point must lie on a reached cell
    const double raw = PlanGrids::at(*distances_, grid, nose_x, nose_y);
    if (raw < 0.0 && refuses_) *reason = "trajectory leaves the map or the plan cannot be reached";
    return raw < 0.0 ? unreached_ : raw;
  }
  if (grid.contains(nose) && !blocked(grid.at(nose))) {
    const double raw = PlanGrids::at(*distances_, grid, nose_x, nose_y);
    if (raw >= 0.0) return raw;
  }
  // Where the nose is on no free cell with a way to the plan, the centre counts instead.
  const double centre = PlanGrids::at(*distances_, grid, last.x, last.y);
  return centre >= 0.0 ? centre : unreached_;
}

}  // namespace hidwa_local_planner::critics
