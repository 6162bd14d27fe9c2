// SPDX-License-Identifier: BSD-3-Clause
#include "core/movers/lethal_distances.hpp"

#include <algorithm>
#include <cstring>

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

using Square = LethalDistances::Square;

// No lethal cell is near. Larger than any square of what is, and with one added still a number.
constexpr Square kNone = 16384;
static_assert(LethalDistances::kMost * LethalDistances::kMost < kNone);
static_assert(kNone + LethalDistances::kMost * LethalDistances::kMost <= 32767);

// Of a strip: its least squares stay in registers.
constexpr std::size_t kColumns = 32;

// As many columns as the strips have that hold these.
std::size_t whole_strips(int columns) {
  return (static_cast<std::size_t>(columns) + kColumns - 1) / kColumns * kColumns;
}

Square square(int distance) { return static_cast<Square>(distance * distance); }

// In a strip the least of `count` rows, the first of them `off` rows away.
HIDWA_VECTOR_CLONES
void least_of_rows(const Square* __restrict along, std::size_t stride, const std::uint8_t* any_near, int count, int off,
                   Square* __restrict squares) {
  Square least[kColumns];
  for (std::size_t k = 0; k < kColumns; ++k) least[k] = kNone;
  for (int row = 0; row < count; ++row, along += stride) {
    if (any_near[row] == 0) continue;
    const Square across = square(off + row);
    for (std::size_t k = 0; k < kColumns; ++k) {
      const auto sum = static_cast<Square>(along[k] + across);
      least[k] = sum < least[k] ? sum : least[k];
    }
  }
  std::memcpy(squares, least, sizeof(least));
}

}  // namespace

void LethalDistances::reserve(int size_x, int size_y) {
  const auto rows = static_cast<std::size_t>(size_y);
  for (std::vector<Square>* values : {&along_, &squares_}) values->reserve(rows * whole_strips(size_x));
  any_near_.reserve(rows);
}

void LethalDistances::measure(const GridView& grid, const CellWindow& window, int reach) {
  window_ = window;
  stride_ = whole_strips(window.width());
  squares_.resize(offset(window.height()));
  const int first = std::max(0, window.j0 - reach), end = std::min(grid.size_y, window.j1 + reach);
  along_.resize(offset(end - first));
  any_near_.resize(static_cast<std::size_t>(end - first));
  for (int j = first; j < end; ++j) {
    const bool any = measure_row(grid, j, reach, along_.data() + offset(j - first));
    any_near_[static_cast<std::size_t>(j - first)] = any ? 1 : 0;
  }
  for (int j = window.j0; j < window.j1; ++j) {
    const int from = std::max(first, j - reach), to = std::min(end, j + reach + 1);
    for (std::size_t column = 0; column < stride_; column += kColumns) {
      least_of_rows(along_.data() + offset(from - first) + column, stride_, any_near_.data() + (from - first),
                    to - from, from - j, squares_.data() + offset(j - window.j0) + column);
    }
  }
}

// In the row alone; false where no lethal cell is within the reach.
bool LethalDistances::measure_row(const GridView& grid, int j, int reach, Square* squares) const {
  std::fill_n(squares, stride_, kNone);
  const std::uint8_t* costs = grid.costs + grid.index({0, j});
  const int first = std::max(0, window_.i0 - reach), end = std::min(grid.size_x, window_.i1 + reach);
  bool any = false;
  for (int lethal = first; lethal < end; ++lethal) {
    if (costs[lethal] != cost::kLethal) continue;
    any = true;
    const int last = std::min(window_.i1 - 1, lethal + reach);
    for (int i = std::max(window_.i0, lethal - reach); i <= last; ++i) {
      Square& nearest = squares[i - window_.i0];
      nearest = std::min(nearest, square(i - lethal));
    }
  }
  return any;
}

}  // namespace hidwa_local_planner
