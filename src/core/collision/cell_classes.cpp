// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/cell_classes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/collision/rounding.hpp"
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

// Where a tile's poses lie: in every step each candidate is as fast as the slowest one, `a`, the fastest one, `b`, or
// something between, and so is how far it gets along either axis.
struct Extremes {
  const double* x;
  const double* y;
  std::size_t stride, a, b;
};

// The boxes of all rows, then the one of all, as least x, least y, and most x and most y negated: what grows is then
// always the least of two.
HIDWA_VECTOR_CLONES
void bound_rows(const Extremes& tile, std::size_t rows, double* boxes) {
  const double* x = tile.x;
  const double* y = tile.y;
  Four slow = {x[tile.a], y[tile.a], -x[tile.a], -y[tile.a]}, fast = slow;  // all begin at the same pose
  Four box = slow - kRounding, all = box;
  std::memcpy(boxes, &box, sizeof(box));
  for (std::size_t k = 1; k < rows; ++k) {
    const std::size_t a = k * tile.stride + tile.a, b = k * tile.stride + tile.b;
    const Four slow_next = {x[a], y[a], -x[a], -y[a]}, fast_next = {x[b], y[b], -x[b], -y[b]};
    const Four by_slow = slow_next - slow, by_fast = fast_next - fast;
    box += by_slow < by_fast ? by_slow : by_fast;
    all = box < all ? box : all;
    std::memcpy(boxes + 4 * k, &box, sizeof(box));
    slow = slow_next;
    fast = fast_next;
  }
  std::memcpy(boxes + 4 * rows, &all, sizeof(all));
}

// The cells of the corners of such boxes, rounded down: the lowest i and j, the highest i and j.
HIDWA_VECTOR_CLONES
void find_corners(const Table& t, const double* __restrict boxes, std::size_t count, std::int32_t* __restrict cells) {
  // What lies below the first cell is far from rounding to it.
  const double scale[4] = {t.cells_per_metre, t.cells_per_metre, -t.cells_per_metre, -t.cells_per_metre};
  const double first[4] = {1.0 - t.corner_x * t.cells_per_metre, 1.0 - t.corner_y * t.cells_per_metre,
                           1.0 - t.corner_x * t.cells_per_metre, 1.0 - t.corner_y * t.cells_per_metre};
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t side = 0; side < 4; ++side) {
      cells[4 * k + side] = static_cast<std::int32_t>(boxes[4 * k + side] * scale[side] + first[side]) - 1;
    }
  }
}

void look_up(const std::uint8_t* __restrict table, const std::int32_t* __restrict index,
             std::uint8_t* __restrict classes, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) classes[k] = table[index[k]];
}

// Adds the classes of some rows to what was touched. The start does not count: EscapeRule judges a robot that stands in
// collision.
HIDWA_VECTOR_CLONES
void gather(const std::uint8_t* __restrict classes, std::size_t rows, std::size_t stride, bool from_start,
            std::uint8_t* __restrict touched) {
  for (std::size_t c = 0; from_start && c < stride; ++c) {
    touched[c] = static_cast<std::uint8_t>(classes[c] & ~static_cast<unsigned>(cell_class::kHit));
  }
  for (std::size_t k = from_start ? 1 : 0; k < rows; ++k) {
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
  count_marked();
}

// Crow 1984, summed-area tables: how many cells of a box have a class is then four look-ups.
void CellClasses::count_marked() {
  const std::size_t n = static_cast<std::size_t>(table_.width) + 1;
  if (marked_.size() < n * n) marked_.resize(n * n);
  std::fill_n(marked_.begin(), n, 0U);
  for (std::size_t j = 1; j < n; ++j) {
    const std::uint8_t* classes = table_.row(static_cast<int>(j) - 1);
    const std::uint32_t* below = marked_.data() + (j - 1) * n;
    std::uint32_t* sums = marked_.data() + j * n;
    std::uint32_t in_row = 0;
    sums[0] = 0;
    for (std::size_t i = 1; i < n; ++i) {
      in_row += classes[i - 1] != 0 ? 1U : 0U;
      sums[i] = below[i] + in_row;
    }
  }
}

bool CellClasses::unmarked(const std::int32_t* cells) const {
  const std::size_t n = static_cast<std::size_t>(table_.width) + 1;
  const auto i0 = static_cast<std::size_t>(cells[0]), i1 = static_cast<std::size_t>(cells[2]) + 1;
  const auto j0 = static_cast<std::size_t>(cells[1]) * n, j1 = (static_cast<std::size_t>(cells[3]) + 1) * n;
  return marked_[j1 + i1] - marked_[j0 + i1] - marked_[j1 + i0] + marked_[j0 + i0] == 0;
}

bool CellClasses::find_open_rows(const Tile& tile) {
  const auto [slowest, fastest] = std::minmax_element(tile.v, tile.v + tile.count);
  const auto a = static_cast<std::size_t>(slowest - tile.v), b = static_cast<std::size_t>(fastest - tile.v);
  bound_rows({tile.x, tile.y, tile.stride, a, b}, tile.steps + 1, boxes_.data());
  const std::size_t count = tile.steps + 2;
  find_corners(table_, boxes_.data(), count, corners_.data());
  const std::int32_t* whole = corners_.data() + 4 * (count - 1);
  const bool inside = whole[0] >= 0 && whole[1] >= 0 && whole[2] < table_.width && whole[3] < table_.width;
  if (inside && unmarked(whole)) return true;
  for (std::size_t k = 0; k <= tile.steps; ++k) open_[k] = inside && unmarked(corners_.data() + 4 * k) ? 1 : 0;
  return false;
}

void CellClasses::classify_rows(const Tile& tile, std::size_t first, std::size_t end) {
  const std::size_t at = first * tile.stride, size = (end - first) * tile.stride;
  find_cells(table_, tile.x + at, tile.y + at, index_.data(), size);
  look_up(table_.cells.data(), index_.data(), classes_.data() + at, size);
  gather(classes_.data() + at, end - first, tile.stride, first == 0, touched_.data());
}

void CellClasses::reserve(const Tile& tile) {
  const std::size_t size = (tile.steps + 1) * tile.stride;
  if (classes_.size() < size) {
    classes_.resize(size);
    index_.resize(size);
    none_.resize(size);
  }
  if (touched_.size() < tile.stride) touched_.resize(tile.stride);
  if (open_.size() <= tile.steps) {
    open_.resize(tile.steps + 1);
    boxes_.resize(4 * (tile.steps + 2));
    corners_.resize(4 * (tile.steps + 2));
  }
}

TileCells CellClasses::under(const Tile& tile) {
  reserve(tile);
  if (find_open_rows(tile)) return {none_.data(), none_.data(), 0};
  std::fill_n(touched_.begin(), tile.stride, std::uint8_t{0});
  for (std::size_t k = 0; k <= tile.steps;) {
    const std::size_t first = k;
    while (k <= tile.steps && open_[k] == open_[first]) ++k;
    if (open_[first] != 0) {
      std::fill_n(classes_.begin() + static_cast<std::ptrdiff_t>(first * tile.stride), (k - first) * tile.stride,
                  std::uint8_t{0});
    } else {
      classify_rows(tile, first, k);
    }
  }
  TileCells cells{classes_.data(), touched_.data(), 0};
  for (std::size_t c = 0; c < tile.count; ++c) {
    cells.touched_any = static_cast<std::uint8_t>(cells.touched_any | touched_[c]);
  }
  return cells;
}

}  // namespace hidwa_local_planner
