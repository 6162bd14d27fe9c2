// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/cell_index.hpp"

#include "hidwa_local_planner/core/vector_clones.hpp"

namespace hidwa_local_planner::kernel {

HIDWA_VECTOR_CLONES
void index_cells(const GridView& grid, const CellLayout& layout, const double* x, const double* y, double dx, double dy,
                 std::size_t count, std::int32_t* index) {
  const double* __restrict px = x;
  const double* __restrict py = y;
  std::int32_t* __restrict out = index;
  const double scale = 1.0 / grid.resolution;
  const double corner_x = grid.origin_x, corner_y = grid.origin_y;
  const std::int32_t width = grid.size_x, height = grid.size_y;
  const std::int32_t stride = layout.stride, off = layout.off_grid, first = layout.border * (stride + 1);
  // One cell up before truncating, so that what lies just below the corner is not taken for the first cell.
  for (std::size_t c = 0; c < count; ++c) {
    const auto i = static_cast<std::int32_t>((px[c] + dx - corner_x) * scale + 1.0) - 1;
    const auto j = static_cast<std::int32_t>((py[c] + dy - corner_y) * scale + 1.0) - 1;
    const bool inside = (i >= 0) & (i < width) & (j >= 0) & (j < height);
    out[c] = inside ? first + i + j * stride : off;
  }
}

}  // namespace hidwa_local_planner::kernel
