// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shape.hpp"

namespace hidwa_attack {

/// What really stands there: lethal cells, lower left corner of the first one at (0, 0).
class World {
 public:
  World(double width, double height, double resolution)
      : resolution_(resolution),
        columns_(static_cast<int>(std::lround(width / resolution))),
        rows_(static_cast<int>(std::lround(height / resolution))),
        lethal_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

  double resolution() const { return resolution_; }  // [m]
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double width() const { return columns_ * resolution_; }  // [m]
  double height() const { return rows_ * resolution_; }    // [m]
  bool has(int i, int j) const { return i >= 0 && j >= 0 && i < columns_ && j < rows_; }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  bool lethal(int i, int j) const { return has(i, j) && lethal_[index(i, j)] != 0; }
  void set(int i, int j, bool lethal) {
    if (has(i, j)) lethal_[index(i, j)] = lethal ? 1 : 0;
  }
  int cell(double metres) const { return static_cast<int>(std::floor(metres / resolution_)); }
  /// Of a cell's middle along one axis [m].
  double middle(int cell) const { return (cell + 0.5) * resolution_; }

  /// Calls visit(i, j, depth) for every lethal cell in the box of a placed shape grown by `around` [m].
  template <typename Visit>
  void near(const Placed& placed, double around, Visit&& visit) const {
    const int first_i = cell(placed.low().x - around), last_i = cell(placed.high().x + around);
    const int first_j = cell(placed.low().y - around), last_j = cell(placed.high().y + around);
    for (int j = first_j; j <= last_j; ++j) {
      for (int i = first_i; i <= last_i; ++i) {
        if (lethal(i, j)) visit(i, j, placed.depth_in(i * resolution_, j * resolution_, resolution_));
      }
    }
  }

 private:
  double resolution_;
  int columns_, rows_;
  std::vector<std::uint8_t> lethal_;
};

/// The deepest depth in any lethal cell [m], or, where it touches none, minus the distance to the nearest, at most
/// `cap`.
inline double deepest(const World& world, const Placed& placed, double cap) {
  double most = -cap;
  world.near(placed, cap, [&most](int, int, double depth) { most = std::max(most, depth); });
  return most;
}

}  // namespace hidwa_attack
