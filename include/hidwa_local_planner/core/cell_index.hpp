// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "hidwa_local_planner/core/grid_view.hpp"

namespace hidwa_local_planner::kernel {

/// How a table of a grid's cells is stored: rows `stride` apart, `border` cells around the grid.
struct CellLayout {
  std::int32_t stride = 0;
  std::int32_t border = 0;
  std::int32_t off_grid = -1;  // the index for whatever is not on the grid
};

/// Most points that index_cells() takes at once.
constexpr std::size_t kMostPoints = 64;

/// The cells of `count` points (x[c] + dx, y[c] + dy) as indices into such a table.
void index_cells(const GridView& grid, const CellLayout& layout, const double* x, const double* y, double dx, double dy,
                 std::size_t count, std::int32_t* index);

}  // namespace hidwa_local_planner::kernel
