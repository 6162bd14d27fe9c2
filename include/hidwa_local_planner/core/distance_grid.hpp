// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"

namespace hidwa_local_planner {

/// Distance of every cell to the nearest of a set of cells, in whole units so that symmetric scenes give equal values.
class DistanceGrid {
 public:
  static constexpr std::int32_t kUnreached = -1;

  /// Cost-blind Manhattan distance, 4 neighbours, one unit a cell: Nav2's map grid. Sources must lie in the grid.
  void make_l1(const GridView& grid, const std::vector<Cell>& sources);
  /// Around obstacles: 8 neighbours, 5 units straight and 7 diagonally (at most 8 % from Euclidean). Lethal and
  /// inscribed cells block, though a blocked source still seeds. Blocked cells get values too, from the reached ones
  /// beside them on inwards, so that a robot in one still knows its way; nothing passes through them.
  void make_geodesic(const GridView& grid, const std::vector<Cell>& sources);

  /// In units; kUnreached where there is no way. The cell must lie in the grid.
  std::int32_t units(Cell cell) const {
    const std::int32_t value = units_[index(cell)];
    return value >= kFar ? kUnreached : value;
  }
  double metres_per_unit() const { return metres_per_unit_; }

 private:
  static constexpr std::int32_t kFar = 1 << 30;
  enum class Kind : std::uint8_t { free, blocked, border };
  struct Rim {
    std::int32_t units;
    std::uint32_t index;
  };

  // Cells are stored with a border of one cell all around, so that no neighbour needs a bounds test.
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.j + 1) * stride_ + static_cast<std::size_t>(cell.i + 1);
  }
  void reset(const GridView& grid);
  void flood(Kind into);
  void collect_rim();
  void push(std::size_t index, std::int32_t units);

  int size_x_ = 0, size_y_ = 0;
  std::size_t stride_ = 0;
  double metres_per_unit_ = 0.05;
  std::vector<std::int32_t> units_;
  std::vector<Kind> kinds_;
  // Buckets by value modulo their number: a step adds at most 7.
  std::array<std::vector<std::uint32_t>, 8> buckets_;
  std::size_t queued_ = 0;
  std::vector<Rim> rim_;
};

}  // namespace hidwa_local_planner
