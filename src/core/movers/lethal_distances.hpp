// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"

namespace hidwa_local_planner {

/// Cells [i0, i1) x [j0, j1) of a grid.
struct CellWindow {
  int i0 = 0, i1 = 0, j0 = 0, j1 = 0;
  int width() const { return i1 - i0; }
  int height() const { return j1 - j0; }
};

/// How far cells are from the nearest lethal cell: along the rows first, then over the columns, since squares add up.
class LethalDistances {
 public:
  using Square = std::int16_t;       // of a distance [cells^2]
  static constexpr int kMost = 120;  // as far as it can look [cells]

  /// For grids of this size.
  void reserve(int size_x, int size_y);
  /// Of the cells of a window. `reach`: as far as it looks, at most kMost [cells]. Up to there squares are exact; those
  /// of cells that are farther are larger than its square.
  void measure(const GridView& grid, const CellWindow& window, int reach);
  /// Those of row j of the grid, from the window's first column on.
  const Square* row(int j) const { return squares_.data() + offset(j - window_.j0); }

 private:
  std::size_t offset(int row) const { return static_cast<std::size_t>(row) * stride_; }
  bool measure_row(const GridView& grid, int j, int reach, Square* squares) const;

  CellWindow window_;
  std::size_t stride_ = 0;              // from a row to the next one
  std::vector<Square> along_;           // [rows that count, stride] to the nearest lethal cell of the same row
  std::vector<std::uint8_t> any_near_;  // [rows that count] whether one is within the reach
  std::vector<Square> squares_;         // [rows of the window, stride]
};

}  // namespace hidwa_local_planner
