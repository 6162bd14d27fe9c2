// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/cell_index.hpp"

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner::kernel {

HIDWA_VECTOR_CLONES
void find_cells(const GridView& grid, const CellBox& box, const double* x, const double* y, double dx, double dy,
                std::size_t count, std::int32_t* i, std::int32_t* j) {
  const double* __restrict px = x;
  const double* __restrict py = y;
  std::int32_t* __restrict column = i;
  std::int32_t* __restrict row = j;
  const double scale = 1.0 / grid.resolution;
  const double corner_x = grid.origin_x, corner_y = grid.origin_y;
  const std::int32_t first_i = box.i + 1, first_j = box.j + 1, width = box.width, height = box.height;
  // One cell up before truncating, so that what lies just below the corner is not taken for the first cell.
  for (std::size_t c = 0; c < count; ++c) {
    const auto at_i = static_cast<std::int32_t>((px[c] + dx - corner_x) * scale + 1.0) - first_i;
    const auto at_j = static_cast<std::int32_t>((py[c] + dy - corner_y) * scale + 1.0) - first_j;
    const bool inside = (at_i >= 0) & (at_i < width) & (at_j >= 0) & (at_j < height);
    column[c] = inside ? at_i : -1;
    row[c] = at_j;
  }
}

}  // namespace hidwa_local_planner::kernel
