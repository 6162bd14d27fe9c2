// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/cell_classes.hpp"

#include <algorithm>
#include <cmath>

#include "hidwa_local_planner/core/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

// More than a position's rounding over a rollout [m].
constexpr double kRounding = 1e-9;

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

// Adds the classes of some rows to what was touched. The start is no news: a robot that stands in collision is another
// matter.
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
  count_marked();
}

// Crow 1984, summed-area tables: how many cells of a box have a class is then four look-ups.
void CellClasses::count_marked() {
  const std::size_t n = static_cast<std::size_t>(width_) + 1;
  if (marked_.size() < n * n) marked_.resize(n * n);
  std::fill_n(marked_.begin(), n, 0U);
  for (std::size_t j = 1; j < n; ++j) {
    const std::uint8_t* classes = table_.data() + ((j - 1) << shift_);
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

bool CellClasses::unmarked(const Box& box) const {
  const double lo_i = (box.lo_x - corner_x_) * cells_per_metre_, hi_i = (box.hi_x - corner_x_) * cells_per_metre_;
  const double lo_j = (box.lo_y - corner_y_) * cells_per_metre_, hi_j = (box.hi_y - corner_y_) * cells_per_metre_;
  if (!(lo_i >= 0.0 && lo_j >= 0.0 && hi_i < width_ && hi_j < width_)) return false;
  const std::size_t n = static_cast<std::size_t>(width_) + 1;
  const auto i0 = static_cast<std::size_t>(lo_i), i1 = static_cast<std::size_t>(hi_i) + 1;
  const auto j0 = static_cast<std::size_t>(lo_j) * n, j1 = (static_cast<std::size_t>(hi_j) + 1) * n;
  return marked_[j1 + i1] - marked_[j0 + i1] - marked_[j1 + i0] + marked_[j0 + i0] == 0;
}

// All candidates of a tile turn alike, and in every step each is as fast as the slowest, the fastest or something between:
// so is how far it gets along either axis.
void CellClasses::find_open_rows(const Tile& tile) {
  const auto [slow, fast] = std::minmax_element(tile.v, tile.v + tile.count);
  const auto a = static_cast<std::size_t>(slow - tile.v), b = static_cast<std::size_t>(fast - tile.v);
  Box box{tile.x[0] - kRounding, tile.y[0] - kRounding, tile.x[0] + kRounding, tile.y[0] + kRounding};
  Box all = box;
  boxes_[0] = box;
  for (std::size_t k = 1; k <= tile.steps; ++k) {
    const std::size_t now = k * tile.stride, before = now - tile.stride;
    const double ax = tile.x[now + a] - tile.x[before + a], bx = tile.x[now + b] - tile.x[before + b];
    const double ay = tile.y[now + a] - tile.y[before + a], by = tile.y[now + b] - tile.y[before + b];
    box.lo_x += std::min(ax, bx);
    box.hi_x += std::max(ax, bx);
    box.lo_y += std::min(ay, by);
    box.hi_y += std::max(ay, by);
    boxes_[k] = box;
    all = {std::min(all.lo_x, box.lo_x), std::min(all.lo_y, box.lo_y), std::max(all.hi_x, box.hi_x),
           std::max(all.hi_y, box.hi_y)};
  }
  const bool all_open = unmarked(all);
  for (std::size_t k = 0; k <= tile.steps; ++k) open_[k] = all_open || unmarked(boxes_[k]) ? 1 : 0;
}

void CellClasses::classify_rows(const Tile& tile, std::size_t first, std::size_t end) {
  const std::size_t at = first * tile.stride, size = (end - first) * tile.stride;
  find_cells({corner_x_, corner_y_, cells_per_metre_, shift_, wrap_}, tile.x + at, tile.y + at, index_.data(), size);
  look_up(table_.data(), index_.data(), classes_.data() + at, size);
  gather(classes_.data() + at, end - first, tile.stride, first == 0, touched_.data());
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
  if (open_.size() <= tile.steps) {
    open_.resize(tile.steps + 1);
    boxes_.resize(tile.steps + 1);
  }
  find_open_rows(tile);
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
  tile.classes = classes_.data();
  tile.touched = touched_.data();
}

}  // namespace hidwa_local_planner
