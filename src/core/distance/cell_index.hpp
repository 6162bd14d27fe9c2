// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "hidwa_local_planner/core/grid_view.hpp"

namespace hidwa_local_planner::kernel {

/// Points that loops over cells take at once.
constexpr std::size_t kMostPoints = 64;

/// A box of cells.
struct CellBox {
  std::int32_t i = 0, j = 0;           // its lowest cell
  std::int32_t width = 0, height = 0;  // [cells]

  bool operator==(const CellBox& o) const { return i == o.i && j == o.j && width == o.width && height == o.height; }
};

/// The cells of `count` points (x[c] + dx, y[c] + dy), counted from the lowest cell of the box; i is negative for those
/// outside it.
void find_cells(const GridView& grid, const CellBox& box, const double* x, const double* y, double dx, double dy,
                std::size_t count, std::int32_t* i, std::int32_t* j);

}  // namespace hidwa_local_planner::kernel
