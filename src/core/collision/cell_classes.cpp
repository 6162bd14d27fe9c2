// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/cell_classes.hpp"

#include <algorithm>
#include <cmath>

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

using Table = CellClasses::Table;

// Indices into the table. Its corner lies below all poses, so that truncating is rounding down.
HIDWA_VECTOR_CLONES
void find_cells(const Table& t, const double* __restrict x, const double* __restrict y, std::int32_t* __restrict index,
                std::size_t count) {
  const double corner_x = t.corner_x, corner_y = t.corner_y, scale = t.cells_per_metre;
  const int shift = t.shift;
  const auto wrap = static_cast<std::uint32_t>(t.size() - 1);
  for (std::size_t c = 0; c < count; ++c) {
    const auto i = static_cast<std::int32_t>((x[c] - corner_x) * scale);
    const auto j = static_cast<std::uint32_t>(static_cast<std::int32_t>((y[c] - corner_y) * scale));
    index[c] = static_cast<std::int32_t>((static_cast<std::uint32_t>(i) + (j << shift)) & wrap);
  }
}

void look_up(const std::uint8_t* __restrict table, const std::int32_t* __restrict index,
             std::uint8_t* __restrict classes, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) classes[k] = table[index[k]];
}

// The classes that each candidate touches. The start does not count: EscapeRule judges a robot that stands in
// collision.
HIDWA_VECTOR_CLONES
void gather(const std::uint8_t* __restrict classes, std::size_t rows, std::size_t stride,
            std::uint8_t* __restrict touched) {
  for (std::size_t c = 0; c < stride; ++c) {
    touched[c] = static_cast<std::uint8_t>(classes[c] & ~static_cast<unsigned>(cell_class::kHit));
  }
  for (std::size_t k = 1; k < rows; ++k) {
    const std::uint8_t* __restrict row = classes + k * stride;
    for (std::size_t c = 0; c < stride; ++c) touched[c] = static_cast<std::uint8_t>(touched[c] | row[c]);
  }
}

void block_by_cost(const std::uint8_t* __restrict costs, int count, bool unknown_blocks,
                   std::uint8_t* __restrict classes) {
  const std::uint8_t third = unknown_blocks ? cost::kUnknown : cost::kLethal;
  for (int i = 0; i < count; ++i) {
    const bool blocked = (costs[i] == cost::kLethal) | (costs[i] == cost::kInscribed) | (costs[i] == third);
    classes[i] = static_cast<std::uint8_t>(classes[i] | (blocked ? cell_class::kBlocked : 0));
  }
}

// The classes of `width` cells of the map from `first` on.
void fill_row(const CollisionChecker& checker, const GridView& grid, bool unknown_blocks, Cell first, int width,
              std::uint8_t* classes) {
  for (int i = 0; i < width; i += 64) {
    const Cell from{first.i + i, first.j};
    std::uint8_t near[64], hit[64];
    BitGrid::unpack(checker.near_bits(from), near);
    BitGrid::unpack(checker.hit_bits(from), hit);
    const int end = std::min(width - i, 64);
    for (int b = 0; b < end; ++b) {
      classes[i + b] = static_cast<std::uint8_t>(near[b] * cell_class::kNear + hit[b] * cell_class::kHit);
    }
  }
  // Beyond the map everything is blocked.
  const bool on_map = first.j >= 0 && first.j < grid.size_y;
  const int begin = on_map ? std::clamp(-first.i, 0, width) : width;
  const int end = on_map ? std::clamp(grid.size_x - first.i, begin, width) : width;
  for (int i = 0; i < begin; ++i) classes[i] |= cell_class::kBlocked;
  for (int i = end; i < width; ++i) classes[i] |= cell_class::kBlocked;
  if (begin == end) return;
  block_by_cost(grid.costs + grid.index({first.i + begin, first.j}), end - begin, unknown_blocks, classes + begin);
}

}  // namespace

void CellClasses::prepare(const CollisionChecker& checker, const GridView& grid, bool unknown_is_obstacle,
                          const Pose2& centre, double reach) {
  const int radius = static_cast<int>(std::ceil(reach / grid.resolution)) + 1;
  const Cell middle = grid.cell_at(centre.x, centre.y);
  const Cell first{middle.i - radius, middle.j - radius};
  table_.corner_x = grid.origin_x + first.i * grid.resolution;
  table_.corner_y = grid.origin_y + first.j * grid.resolution;
  table_.cells_per_metre = 1.0 / grid.resolution;
  table_.width = 2 * radius + 1;
  table_.shift = 0;
  while ((1 << table_.shift) < table_.width) ++table_.shift;
  if (table_.cells.size() < table_.size()) table_.cells.resize(table_.size());
  for (int j = 0; j < table_.width; ++j) {
    fill_row(checker, grid, unknown_is_obstacle, {first.i, first.j + j}, table_.width, table_.row(j));
  }
}

TileCells CellClasses::under(const Tile& tile) {
  const std::size_t rows = tile.steps + 1, size = rows * tile.stride;
  if (classes_.size() < size) {
    classes_.resize(size);
    index_.resize(size);
  }
  touched_.assign(tile.stride, 0);
  find_cells(table_, tile.x, tile.y, index_.data(), size);
  look_up(table_.cells.data(), index_.data(), classes_.data(), size);
  gather(classes_.data(), rows, tile.stride, touched_.data());
  TileCells cells{classes_.data(), touched_.data(), 0};
  for (std::size_t c = 0; c < tile.count; ++c) {
    cells.touched_any = static_cast<std::uint8_t>(cells.touched_any | touched_[c]);
  }
  return cells;
}

}  // namespace hidwa_local_planner
