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
  const auto cells = static_cast<std::size_t>(radius_);
  const std::size_t beyond = cells * cells + 1;
  cost_.assign(beyond + 1, cost::kFree);
  for (std::size_t squared = 0; squared < beyond; ++squared) {
    const double distance = std::sqrt(static_cast<double>(squared)) * resolution;
    cost_[squared] = inflated_cost(distance, inscribed_radius, settings.cost_scaling_factor);
  }
}

void Inflation::inflate(const RollingGrid& obstacles, RollingGrid& costs) {
  measure_columns(obstacles);
  for (int j = 0; j < cells_; ++j) inflate_row(j, costs.row(j));
}

void Inflation::measure_columns(const RollingGrid& obstacles) {
  cells_ = obstacles.cells();
  const auto far = static_cast<std::uint16_t>(radius_ + 1);
  const auto width = static_cast<std::size_t>(cells_);
  column_.resize(width * width);
  row_has_any_.resize(width);
  squared_.assign(width, far);  // the row before
  for (int j = 0; j < cells_; ++j) {
    const std::uint8_t* costs = obstacles.row(j);
    std::uint16_t* row = column_.data() + static_cast<std::size_t>(j) * width;
    for (std::size_t i = 0; i < width; ++i) {
      const auto farther = static_cast<std::uint16_t>(squared_[i] + 1);
      row[i] = costs[i] == cost::kLethal ? std::uint16_t{0} : std::min(far, farther);
      squared_[i] = row[i];
    }
  }
  squared_.assign(width, far);
  for (int j = cells_ - 1; j >= 0; --j) {
    std::uint16_t* row = column_.data() + static_cast<std::size_t>(j) * width;
    std::uint16_t least = far;
    for (std::size_t i = 0; i < width; ++i) {
      row[i] = std::min(row[i], static_cast<std::uint16_t>(squared_[i] + 1));
      squared_[i] = row[i];
      least = std::min(least, row[i]);
    }
    row_has_any_[static_cast<std::size_t>(j)] = least < far;
  }
}

void Inflation::inflate_row(int j, std::uint8_t* costs) {
  const auto width = static_cast<std::size_t>(cells_), radius = static_cast<std::size_t>(radius_);
  if (row_has_any_[static_cast<std::size_t>(j)] == 0) {
    std::fill_n(costs, width, cost::kFree);
    return;
  }
  const auto beyond = static_cast<std::uint16_t>(radius_ * radius_ + 1);
  squared_.assign(width + 2 * radius, beyond);
  const std::uint16_t* column = column_.data() + static_cast<std::size_t>(j) * width;
  for (std::size_t i = 0; i < width; ++i) {
    squared_[i + radius] = std::min(beyond, static_cast<std::uint16_t>(column[i] * column[i]));
  }
  nearest_.assign(squared_.begin() + radius_, squared_.begin() + radius_ + cells_);
  for (std::size_t d = 1; d <= radius; ++d) {
    const std::uint16_t* left = squared_.data() + radius - d;
    const std::uint16_t* right = squared_.data() + radius + d;
    std::uint16_t* nearest = nearest_.data();
    const auto across = static_cast<std::uint16_t>(d * d);
    for (std::size_t i = 0; i < width; ++i) {
      const auto beside = static_cast<std::uint16_t>(std::min(left[i], right[i]) + across);
      nearest[i] = std::min(nearest[i], beside);
    }
  }
  for (std::size_t i = 0; i < width; ++i) costs[i] = cost_[std::min(nearest_[i], beyond)];
}

}  // namespace drive
}  // namespace hidwa_local_planner
