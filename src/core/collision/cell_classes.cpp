// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/cell_classes.hpp"

#include <cstddef>

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

constexpr unsigned kClasses = cell_class::kNear | cell_class::kHit | cell_class::kBlocked;

// Indices into the checker's cells. Their corner lies below all poses, so that truncating is rounding down. All poses
// lie within; one beyond would count in the nearest cell.
HIDWA_VECTOR_CLONES
void find_cells(const CollisionChecker& checker, const double* __restrict x, const double* __restrict y,
                std::int32_t* __restrict index, std::size_t count) {
  const Point corner = checker.corner();
  const double corner_x = corner.x(), corner_y = corner.y(), scale = 1.0 / checker.resolution();
  const std::int32_t last_i = checker.cells().width() - 1, last_j = checker.cells().height() - 1;
  const auto stride = static_cast<std::int32_t>(checker.cells().stride());
  for (std::size_t c = 0; c < count; ++c) {
    const auto at_i = static_cast<std::int32_t>((x[c] - corner_x) * scale);
    const auto at_j = static_cast<std::int32_t>((y[c] - corner_y) * scale);
    const std::int32_t up_to_i = at_i < last_i ? at_i : last_i, up_to_j = at_j < last_j ? at_j : last_j;
    index[c] = (up_to_j > 0 ? up_to_j : 0) * stride + (up_to_i > 0 ? up_to_i : 0);
  }
}

void look_up(const std::uint8_t* __restrict cells, const std::int32_t* __restrict index,
             std::uint8_t* __restrict classes, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) classes[k] = static_cast<std::uint8_t>(cells[index[k]] & kClasses);
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

}  // namespace

TileCells CellClasses::under(const CollisionChecker& checker, const Tile& tile) {
  const std::size_t rows = tile.steps + 1, size = rows * tile.stride;
  if (classes_.size() < size) {
    classes_.resize(size);
    index_.resize(size);
  }
  touched_.assign(tile.stride, 0);
  find_cells(checker, tile.x, tile.y, index_.data(), size);
  look_up(checker.cells().row(0), index_.data(), classes_.data(), size);
  gather(classes_.data(), rows, tile.stride, touched_.data());
  TileCells cells{classes_.data(), touched_.data(), 0};
  for (std::size_t c = 0; c < tile.count; ++c) {
    cells.touched_any = static_cast<std::uint8_t>(cells.touched_any | touched_[c]);
  }
  return cells;
}

}  // namespace hidwa_local_planner
