// SPDX-License-Identifier: BSD-3-Clause
#include "core/search/search_task.hpp"

#include <algorithm>
#include <cmath>

#include "core/util/nearest_pose.hpp"
#include "core/util/rotation.hpp"
#include "hidwa_local_planner/core/util/archive.hpp"

namespace hidwa_local_planner {
namespace {

// How far from the robot the snapshot ends [m].
constexpr double kSnapshotReach = 4.0;

// The target lies so far along the plan [m].
constexpr double kTargetFrom = 1.5;
constexpr double kTargetTo = 2.5;

// The last part of a plan that ends before that [m].
constexpr double kTargetAtEnd = 0.3;

// A way has to come so near to it [m].
constexpr double kNearTarget = 0.15;

// A way to the goal's pose ends within this share of both tolerances; headings are found so exactly [rad].
constexpr double kWithinTolerance = 0.8;
constexpr double kHeadingExact = 0.1;

// Memory is kept for so many points of it.
constexpr std::size_t kUsualTarget = 256;

// What is marked so near to the edge of something that moves is its own [m].
constexpr double kBeside = 0.1;

void copy_map(const GridView& grid, const Pose2& pose, MapCopy& copy) {
  const int reach = static_cast<int>(std::ceil(kSnapshotReach / grid.resolution));
  const Cell middle = grid.cell_at(pose.x, pose.y);
  const int i0 = std::clamp(middle.i - reach, 0, grid.size_x), i1 = std::clamp(middle.i + reach + 1, i0, grid.size_x);
  const int j0 = std::clamp(middle.j - reach, 0, grid.size_y), j1 = std::clamp(middle.j + reach + 1, j0, grid.size_y);
  copy.size_x = i1 - i0;
  copy.size_y = j1 - j0;
  copy.resolution = grid.resolution;
  copy.origin_x = grid.origin_x + i0 * grid.resolution;
  copy.origin_y = grid.origin_y + j0 * grid.resolution;
  copy.costs.clear();
  copy.costs.reserve(static_cast<std::size_t>(2 * reach + 1) * static_cast<std::size_t>(2 * reach + 1));
  for (int j = j0; j < j1; ++j) {
    const std::uint8_t* row = grid.costs + grid.index({i0, j});
    copy.costs.insert(copy.costs.end(), row, row + copy.size_x);
  }
}

// A circle whose centre stands in an inscribed cell is judged by its outline alone: so must be its ways.
void drop_inscribed(SearchTask& task) {
  const Cell cell = task.grid().cell_at(task.start.x, task.start.y);
  if (task.radius <= 0.0 || !task.grid().contains(cell) || task.grid().at(cell) != cost::kInscribed) return;
  std::replace(task.map.costs.begin(), task.map.costs.end(), cost::kInscribed, cost::kFree);
}

void find_target(const std::vector<Pose2>& plan, SearchTask& task) {
  const GridView grid = task.grid();
  task.target.clear();
  task.target.reserve(kUsualTarget);
  const auto nearest = static_cast<std::size_t>(nearest_pose(plan, task.start) - plan.begin());
  // As far as it is on the map.
  double length = 0.0;
  std::size_t end = nearest;
  while (end < plan.size() && grid.contains(grid.cell_at(plan[end].x, plan[end].y))) {
    if (end > nearest) length += distance(plan[end - 1], plan[end]);
    ++end;
  }
  const double from = length >= kTargetFrom ? kTargetFrom : std::max(0.0, length - kTargetAtEnd);
  double along = 0.0;
  for (std::size_t i = nearest; i < end; ++i) {
    if (i > nearest) along += distance(plan[i - 1], plan[i]);
    if (along >= from && along <= std::max(kTargetTo, from)) task.target.emplace_back(plan[i].x, plan[i].y);
  }
}

// Cells whose middle is within `reach` of a point.
template <typename Visit>
void for_cells_within(const Point& point, double reach, const GridView& grid, Visit&& visit) {
  const auto cells = [&](double from, double to, int size) {
    return std::clamp(static_cast<int>(std::floor(std::clamp((from - to) / grid.resolution, -1e6, 1e6))), 0, size);
  };
  const int i0 = cells(point.x() - reach, grid.origin_x, grid.size_x);
  const int i1 = cells(point.x() + reach + grid.resolution, grid.origin_x, grid.size_x);
  const int j0 = cells(point.y() - reach, grid.origin_y, grid.size_y);
  const int j1 = cells(point.y() + reach + grid.resolution, grid.origin_y, grid.size_y);
  for (int j = j0; j < j1; ++j) {
    for (int i = i0; i < i1; ++i) {
      if ((grid.centre({i, j}) - point).norm() <= reach) visit(Cell{i, j});
    }
  }
}

}  // namespace

bool SearchTask::operator==(const SearchTask& other) const {
  Bytes mine, its;
  ArchiveWriter{mine}(*this);
  ArchiveWriter{its}(other);
  return mine == its;
}

bool MapCopy::plausible() const {
  constexpr int kMostCells = 1 << 14;  // a side
  return size_x > 0 && size_y > 0 && size_x < kMostCells && size_y < kMostCells &&
         costs.size() == view().cell_count() && resolution > 1e-4 && resolution < 10.0;
}

bool SearchTask::plausible() const {
  constexpr std::size_t kMostCorners = 1 << 12;
  if (!map.plausible() || outline.size() >= kMostCorners || !is_finite(start)) return false;
  const auto usual = [](double value) { return value >= 0.0 && value < 1e3; };
  const bool robot = usual(radius) && usual(forward) && usual(backward) && usual(turning) && usual(near_target) &&
                     std::isfinite(heading) && usual(heading_off);
  const Footprint body = footprint();
  return robot && body.fault() == nullptr && !body.empty() && grid().contains(grid().cell_at(start.x, start.y));
}

void add_movers(const MovingObstacleEstimates& movers, const Footprint& footprint, SearchTask& task) {
  const GridView grid = task.grid();
  const TurnedPose robot = TurnedPose::of(task.start);
  for (const MovingObstacleEstimate& mover : movers) {
    for_cells_within(mover.position_now(), mover.radius + 0.5 * grid.resolution, grid, [&](const Cell& cell) {
      if (footprint.distance_to(robot.seen(grid.centre(cell))) <= grid.resolution) return;
      task.map.costs[grid.index(cell)] = cost::kLethal;
    });
  }
}

void remove_movers(const MovingObstacleEstimates& movers, SearchTask& task) {
  const GridView grid = task.grid();
  for (const MovingObstacleEstimate& mover : movers) {
    for_cells_within(mover.position_now(), mover.radius + kBeside, grid,
                     [&](const Cell& cell) { task.map.costs[grid.index(cell)] = cost::kFree; });
  }
}

void make_search_task(const Pose2& start, const std::vector<Pose2>& plan, const GridView& grid,
                      const Footprint& footprint, const Parameters& parameters, const VelocityLimits& limits,
                      SearchTask& task) {
  task.unknown_is_obstacle = parameters.unknown_is_obstacle;
  task.start = start;
  task.outline.clear();
  if (!footprint.is_circle()) task.outline = footprint.outline();
  task.radius = footprint.radius();
  task.forward = std::max(limits.x.max, 0.0);
  task.backward = std::max(-limits.x.min, 0.0);
  task.turning = std::max(std::min(limits.theta.max, -limits.theta.min), 0.0);
  task.near_target = std::max(kNearTarget, grid.resolution);
  task.heading = 0.0;
  task.heading_off = SearchTask::kAnyHeading;
  copy_map(grid, start, task.map);
  drop_inscribed(task);
  find_target(plan, task);
}

void aim_at_goal(const Pose2& goal, const Parameters& parameters, SearchTask& task) {
  task.target.assign(1, Point(goal.x, goal.y));
  task.near_target = std::max(kWithinTolerance * parameters.xy_goal_tolerance, task.map.resolution);
  task.heading = goal.theta;
  task.heading_off = std::max(kWithinTolerance * parameters.yaw_goal_tolerance, kHeadingExact);
}

}  // namespace hidwa_local_planner
