// SPDX-License-Identifier: BSD-3-Clause
#include "drive/rolling_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace hidwa_local_planner {
namespace drive {
namespace {

// Whole cells, towards zero; what falls short of a whole one by rounding only counts as whole.
int whole_cells(double cells) { return static_cast<int>(cells + std::copysign(1e-6, cells)); }

}  // namespace

RollingGrid::RollingGrid(double width, double resolution)
    : cells_(std::max(1, whole_cells(width / resolution))), resolution_(resolution) {
  costs_.assign(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_), cost::kFree);
  moved_ = costs_;
}

void RollingGrid::follow(double x, double y) {
  const double half = 0.5 * cells_ * resolution_;
  const int di = whole_cells((x - half - origin_x()) / resolution_);
  const int dj = whole_cells((y - half - origin_y()) / resolution_);
  if (di == 0 && dj == 0) return;
  column_ += di;
  row_ += dj;
  std::fill(moved_.begin(), moved_.end(), cost::kFree);
  const int kept = cells_ - std::abs(di);
  for (int j = std::max(0, -dj); kept > 0 && j < std::min(cells_, cells_ - dj); ++j) {
    const std::uint8_t* from = row(j + dj) + std::max(0, di);
    std::copy(from, from + kept, moved_.data() + index(std::max(0, -di), j));
  }
  costs_.swap(moved_);
}

GridView RollingGrid::view() const { return {costs_.data(), cells_, cells_, resolution_, origin_x(), origin_y()}; }

void RollingGrid::take_place_of(const RollingGrid& other) {
  column_ = other.column_;
  row_ = other.row_;
}

}  // namespace drive
}  // namespace hidwa_local_planner
