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

/// How far cells of a window are from the nearest lethal cell of it.
///
/// The window is cut into strips of kColumns columns. A strip's row is measured where it is wanted and one of its cells
/// is not free. Along the rows first, then over the columns: squares add up.
class LethalDistances {
 public:
  using Square = std::int16_t;         // of a distance [cells^2]
  static constexpr int kColumns = 32;  // of a strip
  static constexpr int kMost = 120;    // as far as it can look [cells]

  /// For windows of a grid of this size.
  void reserve(int size_x, int size_y);
  /// The next window. `reach`: as far as it looks, at most kMost [cells]. Nothing is wanted yet.
  void begin(const CellWindow& window, int reach);
  /// What is within the reach of a cell of the window, along both axes, is wanted.
  void want_around(const Cell& cell);
  /// Up to the reach squares are exact; those of cells that are farther are larger than its square.
  void measure(const GridView& grid);

  int strips() const { return strips_; }
  /// Row j of a strip, kColumns squares, those beyond the window without meaning; null where it was not measured.
  const Square* row(int strip, int j) const {
    const std::size_t k = index(strip, j);
    return measured_[k] != 0 ? squares_.data() + k * kColumns : nullptr;
  }

 private:
  std::size_t index(int strip, int j) const {
    return static_cast<std::size_t>(strip) * static_cast<std::size_t>(window_.height()) +
           static_cast<std::size_t>(j - window_.j0);
  }
  bool measure_along(const std::uint8_t* costs, Square* squares) const;
  void measure_row(const GridView& grid, int j);
  bool free(const GridView& grid, int strip, int j) const;

  CellWindow window_;
  int reach_ = 0;
  int strips_ = 0;
  std::vector<Square> one_row_;                // [columns] to the nearest lethal cell of the same row
  std::vector<Square> along_, squares_;        // [strips * rows * kColumns] in the row, and in all rows
  std::vector<std::uint8_t> wanted_;           // [strips * rows]
  std::vector<std::uint8_t> near_, measured_;  // [strips * rows] whether a lethal cell of the row is near; as row()
};

}  // namespace hidwa_local_planner
