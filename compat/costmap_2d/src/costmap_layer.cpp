// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <costmap_2d/costmap_layer.h>
#include <costmap_2d/layered_costmap.h>

#include <algorithm>
#include <limits>

namespace costmap_2d {
namespace {

constexpr double kFar = std::numeric_limits<double>::max();

}  // namespace

const CostmapLayer::Bounds CostmapLayer::kNowhere{kFar, kFar, -kFar, -kFar};

void CostmapLayer::matchSize() {
  const Costmap2D& master = *layered_costmap_->getCostmap();
  resizeMap(master.getSizeInCellsX(), master.getSizeInCellsY(), master.getResolution(), master.getOriginX(),
            master.getOriginY());
}

void CostmapLayer::clearArea(int start_x, int start_y, int end_x, int end_y, bool invert_area) {
  const auto within = [](unsigned int cell, int start, int end) {
    return static_cast<int>(cell) > start && static_cast<int>(cell) < end;
  };
  for (unsigned int y = 0; y < size_y_; ++y) {
    for (unsigned int x = 0; x < size_x_; ++x) {
      const bool inside = within(x, start_x, end_x) && within(y, start_y, end_y);
      if (inside == invert_area) setCost(x, y, NO_INFORMATION);
    }
  }
}

void CostmapLayer::addExtraBounds(double mx0, double my0, double mx1, double my1) {
  extra_ = {std::min(extra_.min_x, mx0), std::min(extra_.min_y, my0), std::max(extra_.max_x, mx1),
            std::max(extra_.max_y, my1)};
}

void CostmapLayer::useExtraBounds(double* min_x, double* min_y, double* max_x, double* max_y) {
  *min_x = std::min(*min_x, extra_.min_x);
  *min_y = std::min(*min_y, extra_.min_y);
  *max_x = std::max(*max_x, extra_.max_x);
  *max_y = std::max(*max_y, extra_.max_y);
  extra_ = kNowhere;
}

}  // namespace costmap_2d
