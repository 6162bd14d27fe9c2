// SPDX-License-Identifier: BSD-3-Clause
#include "core/search/target_distance.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {

void TargetDistance::prepare(const SearchTask& task, const CollisionChecker& checker) {
  task_ = &task;
  grid_ = task.grid();
  blocked_.assign(grid_.cell_count(), cost::kFree);
  block(checker);
  grid_.costs = blocked_.data();
  find_sources();
  distances_.prepare(grid_, MapGridDistance::geodesic);
  distances_.set_sources(0, sources_);
}

void TargetDistance::block(const CollisionChecker& checker) {
  for (int j = 0; j < grid_.size_y; ++j) {
    for (int i = 0; i < grid_.size_x; ++i) {
      if (checker.surely_collides({i, j})) blocked_[grid_.index({i, j})] = cost::kLethal;
    }
  }
}

void TargetDistance::find_sources() {
  sources_.clear();
  sources_.reserve(DistanceGrids::kUsualSources);
  const double near = task_->near_target;
  const int reach = static_cast<int>(std::ceil(near / grid_.resolution));
  for (const Point& point : task_->target) {
    const Cell middle = grid_.cell_at(point.x(), point.y());
    for (int j = middle.j - reach; j <= middle.j + reach; ++j) {
      for (int i = middle.i - reach; i <= middle.i + reach; ++i) {
        if (!grid_.contains({i, j})) continue;
        std::uint8_t& cell = blocked_[grid_.index({i, j})];
        if (cell != cost::kFree || (grid_.centre({i, j}) - point).norm() > near) continue;
        cell = cost::kInscribed;  // is on the list
        sources_.push_back({i, j});
      }
    }
  }
  for (const Cell cell : sources_) blocked_[grid_.index(cell)] = cost::kFree;
}

double TargetDistance::at(double x, double y) {
  const Cell cell = grid_.cell_at(x, y);
  return grid_.contains(cell) && !sources_.empty() ? DistanceGrid(distances_, 0).metres(cell) : -1.0;
}

}  // namespace hidwa_local_planner
