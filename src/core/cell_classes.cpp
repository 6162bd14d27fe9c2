// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/cell_classes.hpp"

#include <algorithm>
#include <cmath>

#include "hidwa_local_planner/core/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

struct Table {
  double corner_x, corner_y, cells_per_metre;
  int shift;
  std::uint32_t wrap;
};

// Indices into the table. Its corner lies below all poses, so that truncating is rounding down.
HIDWA_VECTOR_CLONES
void find_cells(const Table& t, const double* __restrict x, const double* __restrict y, std::int32_t* __restrict index,
                std::size_t count) {
  const double corner_x = t.corner_x, corner_y = t.corner_y, scale = t.cells_per_metre;
  const int shift = t.shift;
  const auto wrap = static_cast<std::int32_t>(t.wrap);
  for (std::size_t c = 0; c < count; ++c) {
    const auto i = static_cast<std::int32_t>((x[c] - corner_x) * scale);
    const auto j = static_cast<std::int32_t>((y[c] - corner_y) * scale);
    index[c] = (i + (j << shift)) & wrap;
  }
}

void look_up(const std::uint8_t* __restrict table, const std::int32_t* __restrict index,
             std::uint8_t* __restrict classes, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) classes[k] = table[index[k]];
}

// The start is no news: a robot that stands in collision is another matter.
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

}  // namespace

void CellClasses::prepare(const CollisionChecker& checker, const GridView& grid, bool unknown_is_obstacle,
                          const Pose2& centre, double reach) {
  const int radius = static_cast<int>(std::ceil(reach / grid.resolution)) + 1;
  const Cell middle = grid.cell_at(centre.x, centre.y);
  first_ = {middle.i - radius, middle.j - radius};
  corner_x_ = grid.origin_x + first_.i * grid.resolution;
  corner_y_ = grid.origin_y + first_.j * grid.resolution;
  cells_per_metre_ = 1.0 / grid.resolution;
  width_ = 2 * radius + 1;
  shift_ = 0;
  while ((1 << shift_) < width_) ++shift_;
  const std::size_t size = std::size_t{1} << (2 * shift_);
  wrap_ = static_cast<std::uint32_t>(size - 1);
  if (table_.size() < size) table_.resize(size);
  std::fill(std::begin(blocked_by_cost_), std::end(blocked_by_cost_), std::uint8_t{0});
  blocked_by_cost_[cost::kLethal] = blocked_by_cost_[cost::kInscribed] = cell_class::kBlocked;
  if (unknown_is_obstacle) blocked_by_cost_[cost::kUnknown] = cell_class::kBlocked;
  for (int row = 0; row < width_; ++row) fill_row(checker, grid, row);
}

void CellClasses::fill_row(const CollisionChecker& checker, const GridView& grid, int row) {
  std::uint8_t* classes = table_.data() + (static_cast<std::size_t>(row) << shift_);
  const int j = first_.j + row;
  for (int i = 0; i < width_; i += 64) {
    const Cell from{first_.i + i, j};
    const std::uint64_t near = checker.near_bits(from), hit = checker.hit_bits(from);
    const int end = std::min(width_ - i, 64);
    for (int b = 0; b < end; ++b) {
      classes[i + b] = static_cast<std::uint8_t>(((near >> b) & 1U) | (((hit >> b) & 1U) << 1));
    }
  }
  const bool on_map = j >= 0 && j < grid.size_y;
  for (int i = 0; i < width_; ++i) {
    const Cell cell{first_.i + i, j};
    const std::uint8_t blocked = on_map && grid.contains(cell) ? blocked_by_cost_[grid.at(cell)] : cell_class::kBlocked;
    classes[i] = static_cast<std::uint8_t>(classes[i] | blocked);
  }
}

void CellClasses::classify(Tile& tile) {
  const std::size_t size = (tile.steps + 1) * tile.stride;
  if (classes_.size() < size) {
    classes_.resize(size);
    index_.resize(size);
  }
  if (touched_.size() < tile.stride) touched_.resize(tile.stride);
  find_cells({corner_x_, corner_y_, cells_per_metre_, shift_, wrap_}, tile.x, tile.y, index_.data(), size);
  look_up(table_.data(), index_.data(), classes_.data(), size);
  gather(classes_.data(), tile.steps + 1, tile.stride, touched_.data());
  tile.classes = classes_.data();
  tile.touched = touched_.data();
}

}  // namespace hidwa_local_planner
