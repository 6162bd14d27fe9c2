// SPDX-License-Identifier: BSD-3-Clause
#include "drive/inflation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hidwa_local_planner {
namespace drive {

std::uint8_t inflated_cost(double distance, double inscribed_radius, double cost_scaling_factor) {
  if (distance == 0.0) return cost::kLethal;
  if (distance <= inscribed_radius) return cost::kInscribed;
  return static_cast<std::uint8_t>((cost::kInscribed - 1) *
                                   std::exp(-cost_scaling_factor * (distance - inscribed_radius)));
}

Inflation::Inflation(const InflationSettings& settings, double inscribed_radius, double resolution)
    : radius_(std::max(0, static_cast<int>(std::ceil(settings.inflation_radius / resolution)))) {
  for (int j = -radius_; j <= radius_; ++j) {
    for (int i = -radius_; i <= radius_; ++i) {
      const int squared = i * i + j * j;
      const double distance = std::sqrt(static_cast<double>(squared)) * resolution;
      const bool within = squared <= radius_ * radius_;
      stamp_.push_back(within ? inflated_cost(distance, inscribed_radius, settings.cost_scaling_factor) : cost::kFree);
    }
  }
}

// Costs fall with the distance: the greatest of all stamps on a cell is that of the nearest lethal one.
void Inflation::inflate(const RollingGrid& obstacles, RollingGrid& costs) const {
  const int cells = obstacles.cells();
  for (int j = 0; j < cells; ++j) std::fill_n(costs.row(j), cells, cost::kFree);
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      if (obstacles.row(j)[i] == cost::kLethal) stamp(i, j, costs);
    }
  }
}

void Inflation::stamp(int i, int j, RollingGrid& costs) const {
  const int side = 2 * radius_ + 1, last = costs.cells() - 1;
  const int first_i = std::max(0, i - radius_), last_i = std::min(last, i + radius_);
  for (int row = std::max(0, j - radius_); row <= std::min(last, j + radius_); ++row) {
    const std::uint8_t* from = stamp_.data() + std::ptrdiff_t{row - j + radius_} * side + (first_i - i + radius_);
    std::uint8_t* to = costs.row(row) + first_i;
    for (int k = 0; k <= last_i - first_i; ++k) to[k] = std::max(to[k], from[k]);
  }
}

}  // namespace drive
}  // namespace hidwa_local_planner
