// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/plan_grids.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hidwa_local_planner {
namespace {

// Between two poses of a plan that far apart is no plan, and its filling takes no longer than this.
constexpr double kMostParts = 1e5;

}  // namespace

PlanGrids::PlanGrids() {
  static_assert(kGoalAhead + kMostAhead <= DistanceGrids::kSets);
  // Plans differ in length from cycle to cycle: room for any usual one.
  path_cells_.reserve(DistanceGrids::kUsualSources);
  moved_cells_.reserve(DistanceGrids::kUsualSources);
  moved_plan_.reserve(DistanceGrids::kUsualSources);
}

void PlanGrids::prepare(const GridView& grid, const std::vector<Pose2>& plan, Method method, bool unknown_is_obstacle) {
  grid_ = grid;
  plan_ = &plan;
  stops_at_unknown_ = method == Method::paper && unknown_is_obstacle;  // Nav2's rule
  known_ahead_ = 0;
  find_cells_on_map(plan, path_cells_);
  distances_.prepare(grid, method == Method::paper ? MapGridDistance::l1 : MapGridDistance::geodesic);
  if (!on_map()) return;
  distances_.set_sources(kPath, path_cells_);
  last_cell_.assign(1, path_cells_.back());
  distances_.set_sources(kGoal, last_cell_);
}

// The cells of the plan's first stretch on the map. Poses in the same or neighbouring cells need nothing between them;
// wider gaps are filled at half a cell's spacing.
void PlanGrids::find_cells_on_map(const std::vector<Pose2>& plan, std::vector<Cell>& cells) const {
  cells.clear();
  // False where the stretch ends.
  const auto take = [&](Cell cell) {
    const bool usable = grid_.contains(cell) && !(stops_at_unknown_ && grid_.at(cell) == cost::kUnknown);
    if (usable) cells.push_back(cell);
    return usable || cells.empty();
  };
  for (std::size_t k = 0; k < plan.size(); ++k) {
    const Cell cell = grid_.cell_at(plan[k].x, plan[k].y);
    if (k > 0) {
      const Cell before = grid_.cell_at(plan[k - 1].x, plan[k - 1].y);
      if (std::max(std::abs(cell.i - before.i), std::abs(cell.j - before.j)) > 1) {
        const double gap = distance(plan[k - 1], plan[k]);
        const int parts = static_cast<int>(std::min(std::ceil(gap / (0.5 * grid_.resolution)), kMostParts));
        for (int part = 1; part < parts; ++part) {
          const double t = static_cast<double>(part) / parts;
          const Cell between = grid_.cell_at(plan[k - 1].x + t * (plan[k].x - plan[k - 1].x),
                                             plan[k - 1].y + t * (plan[k].y - plan[k - 1].y));
          if (!take(between)) return;
        }
      }
    }
    if (!take(cell)) return;
  }
}

DistanceGrid PlanGrids::to_goal_ahead(double ahead, const Pose2& from, const Pose2& goal) {
  const auto kept = [&](std::size_t slot) { return DistanceGrid(distances_, kGoalAhead + static_cast<int>(slot)); };
  if (!on_map()) return kept(0);
  for (std::size_t k = 0; k < known_ahead_; ++k) {
    if (ahead_[k] == ahead) return kept(k);
  }
  known_ahead_ = std::min(known_ahead_ + 1, kMostAhead);  // the last one makes way
  const std::size_t slot = known_ahead_ - 1;
  moved_plan_ = *plan_;
  const double bearing = std::atan2(goal.y - from.y, goal.x - from.x);
  moved_plan_.back().x += ahead * std::cos(bearing);
  moved_plan_.back().y += ahead * std::sin(bearing);
  find_cells_on_map(moved_plan_, moved_cells_);
  last_cell_.assign(1, moved_cells_.empty() ? path_cells_.back() : moved_cells_.back());
  distances_.set_sources(kGoalAhead + static_cast<int>(slot), last_cell_);
  ahead_[slot] = ahead;
  return kept(slot);
}

double PlanGrids::at(const DistanceGrid& distances, const GridView& grid, double x, double y) {
  const Cell cell = grid.cell_at(x, y);
  return grid.contains(cell) ? distances.metres(cell) : -1.0;
}

}  // namespace hidwa_local_planner
