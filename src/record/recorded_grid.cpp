// SPDX-License-Identifier: BSD-3-Clause
#include "record/recorded_grid.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include <zlib.h>

namespace hidwa_local_planner {
namespace record {
namespace {

// A costmap of 4000 x 4000 cells; what says it is larger is damaged.
constexpr std::size_t kMostCells = 16000000;

bool plausible(const RecordedGrid& grid) {
  return grid.size_x > 0 && grid.size_y > 0 && grid.resolution > 0.0 && std::isfinite(grid.origin_x) &&
         std::isfinite(grid.origin_y) &&
         static_cast<std::size_t>(grid.size_x) <= kMostCells / static_cast<std::size_t>(grid.size_y);
}

}  // namespace

RecordedGrid packed(const GridView& grid) {
  if (!grid.valid()) return {};
  RecordedGrid recorded{{grid.size_x, grid.size_y, grid.resolution, grid.origin_x, grid.origin_y}, {}};
  const auto cells = static_cast<uLong>(grid.cell_count());
  uLongf size = compressBound(cells);
  recorded.deflated.resize(size);
  compress2(recorded.deflated.data(), &size, grid.costs, cells, Z_BEST_SPEED);
  recorded.deflated.resize(size);
  return recorded;
}

bool unpack(const RecordedGrid& recorded, StoredGrid& grid) {
  grid = StoredGrid();
  if (recorded.size_x == 0 || recorded.size_y == 0) return true;
  if (!plausible(recorded)) return false;
  Bytes costs(static_cast<std::size_t>(recorded.size_x) * static_cast<std::size_t>(recorded.size_y));
  auto size = static_cast<uLongf>(costs.size());
  const int status =
      uncompress(costs.data(), &size, recorded.deflated.data(), static_cast<uLong>(recorded.deflated.size()));
  if (status != Z_OK || size != costs.size()) return false;
  grid = {recorded, std::move(costs)};
  return true;
}

}  // namespace record
}  // namespace hidwa_local_planner
