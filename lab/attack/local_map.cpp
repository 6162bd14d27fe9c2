// SPDX-License-Identifier: BSD-3-Clause
#include "local_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hidwa_attack {
namespace {

constexpr double kInflation = 0.55;  // [m]
constexpr double kFallOff = 5.0;     // [1/m]

std::uint8_t cost_at(double distance, double inscribed) {
  if (distance <= 0.0) return 254;
  if (distance <= inscribed) return 253;
  if (distance > std::max(kInflation, inscribed)) return 0;
  return static_cast<std::uint8_t>(252.0 * std::exp(-kFallOff * (distance - inscribed)));
}

}  // namespace

LocalMap::LocalMap(const World& world, double side, double inscribed)
    : resolution_(world.resolution()),
      inscribed_(inscribed),
      columns_(world.columns()),
      rows_(world.rows()),
      size_(static_cast<int>(std::ceil(side / world.resolution()))) {
  window_.resize(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_));
  renew(world);
}

// Each lethal cell lowers the distance of those around it; no more is needed within so short a reach.
void LocalMap::renew(const World& world) {
  const int reach = static_cast<int>(std::ceil(std::max(kInflation, inscribed_) / resolution_));
  const std::size_t count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  std::vector<int> squares(count, std::numeric_limits<int>::max());
  for (int j = 0; j < rows_; ++j) {
    for (int i = 0; i < columns_; ++i) {
      if (!world.lethal(i, j)) continue;
      // In the midst of others it is nobody's nearest.
      if (world.lethal(i - 1, j) && world.lethal(i + 1, j) && world.lethal(i, j - 1) && world.lethal(i, j + 1)) {
        squares[world.index(i, j)] = 0;
        continue;
      }
      for (int b = std::max(0, j - reach); b <= std::min(rows_ - 1, j + reach); ++b) {
        for (int a = std::max(0, i - reach); a <= std::min(columns_ - 1, i + reach); ++a) {
          int& square = squares[world.index(a, b)];
          square = std::min(square, (a - i) * (a - i) + (b - j) * (b - j));
        }
      }
    }
  }
  costs_.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    costs_[k] =
        cost_at(squares[k] == std::numeric_limits<int>::max() ? 1e9 : resolution_ * std::sqrt(squares[k]), inscribed_);
  }
}

GridView LocalMap::around(const Pose2& pose) {
  first_i_ = static_cast<int>(std::floor(pose.x / resolution_)) - size_ / 2;
  first_j_ = static_cast<int>(std::floor(pose.y / resolution_)) - size_ / 2;
  std::fill(window_.begin(), window_.end(), std::uint8_t{0});
  const int from = std::max(0, first_i_), to = std::min(columns_, first_i_ + size_);
  for (int row = 0; row < size_ && from < to; ++row) {
    const int j = first_j_ + row;
    if (j < 0 || j >= rows_) continue;
    const auto begin = costs_.begin() + static_cast<std::ptrdiff_t>(j) * columns_;
    std::copy(begin + from, begin + to, window_.begin() + static_cast<std::ptrdiff_t>(row) * size_ + (from - first_i_));
  }
  GridView view;
  view.costs = window_.data();
  view.size_x = view.size_y = size_;
  view.resolution = resolution_;
  view.origin_x = first_i_ * resolution_;
  view.origin_y = first_j_ * resolution_;
  return view;
}

void LocalMap::forget_beyond(const Pose2& sensor, double sight) {
  for (int row = 0; row < size_; ++row) {
    for (int column = 0; column < size_; ++column) {
      const double dx = (first_i_ + column + 0.5) * resolution_ - sensor.x;
      const double dy = (first_j_ + row + 0.5) * resolution_ - sensor.y;
      if (dx * dx + dy * dy > sight * sight)
        window_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(column)] = 0;
    }
  }
}

}  // namespace hidwa_attack
