// SPDX-License-Identifier: BSD-3-Clause
#include "core/movers/lethal_distances.hpp"

#include <algorithm>
#include <cstring>

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

using Square = LethalDistances::Square;
constexpr int kColumns = LethalDistances::kColumns;

// No lethal cell is near. Larger than any square of what is, and with one added still a number.
constexpr Square kNone = 16384;
static_assert(LethalDistances::kMost * LethalDistances::kMost < kNone);
static_assert(kNone + LethalDistances::kMost * LethalDistances::kMost <= 32767);

std::size_t strips_of(int columns) {
  return static_cast<std::size_t>((std::max(0, columns) + kColumns - 1) / kColumns);
}

Square square(int distance) { return static_cast<Square>(distance * distance); }

// The least of `count` rows, the first of them `off` rows away.
HIDWA_VECTOR_CLONES
void least_of_rows(const Square* __restrict along, const std::uint8_t* near, int count, int off,
                   Square* __restrict squares) {
  Square least[kColumns];
  for (int k = 0; k < kColumns; ++k) least[k] = kNone;
  for (int row = 0; row < count; ++row, along += kColumns) {
    if (near[row] == 0) continue;
    const Square across = square(off + row);
    for (int k = 0; k < kColumns; ++k) {
      const auto sum = static_cast<Square>(along[k] + across);
      least[k] = sum < least[k] ? sum : least[k];
    }
  }
  std::memcpy(squares, least, sizeof(least));
}

}  // namespace

void LethalDistances::reserve(int size_x, int size_y) {
  const std::size_t rows = strips_of(size_x) * static_cast<std::size_t>(size_y);
  one_row_.reserve(strips_of(size_x) * kColumns);
  for (std::vector<Square>* values : {&along_, &squares_}) values->reserve(rows * kColumns);
  for (std::vector<std::uint8_t>* flags : {&wanted_, &near_, &measured_}) flags->reserve(rows);
}

void LethalDistances::begin(const CellWindow& window, int reach) {
  window_ = window;
  reach_ = reach;
  strips_ = static_cast<int>(strips_of(window.width()));
  const std::size_t rows = strips_of(window.width()) * static_cast<std::size_t>(std::max(0, window.height()));
  one_row_.resize(strips_of(window.width()) * kColumns);
  for (std::vector<Square>* values : {&along_, &squares_}) values->resize(rows * kColumns);
  for (std::vector<std::uint8_t>* flags : {&wanted_, &near_, &measured_}) flags->assign(rows, 0);
}

void LethalDistances::want_around(const Cell& cell) {
  const int first = std::max(window_.j0, cell.j - reach_), last = std::min(window_.j1 - 1, cell.j + reach_);
  const int left = std::max(window_.i0, cell.i - reach_), right = std::min(window_.i1 - 1, cell.i + reach_);
  for (int strip = (left - window_.i0) / kColumns; strip <= (right - window_.i0) / kColumns; ++strip) {
    std::memset(wanted_.data() + index(strip, first), 1,
                static_cast<std::size_t>(last) - static_cast<std::size_t>(first) + 1);
  }
}

void LethalDistances::measure(const GridView& grid) {
  for (int j = window_.j0; j < window_.j1; ++j) measure_row(grid, j);
  for (int strip = 0; strip < strips_; ++strip) {
    for (int j = window_.j0; j < window_.j1; ++j) {
      const std::size_t k = index(strip, j);
      if (wanted_[k] == 0 || free(grid, strip, j)) continue;
      const int first = std::max(window_.j0, j - reach_), last = std::min(window_.j1 - 1, j + reach_);
      const std::size_t other = index(strip, first);
      measured_[k] = 1;
      least_of_rows(along_.data() + other * kColumns, near_.data() + other, last - first + 1, first - j,
                    squares_.data() + k * kColumns);
    }
  }
}

bool LethalDistances::free(const GridView& grid, int strip, int j) const {
  const int first = window_.i0 + strip * kColumns, count = std::min(kColumns, window_.i1 - first);
  const std::uint8_t* costs = grid.costs + grid.index({first, j});
  unsigned any = 0;
  for (int k = 0; k < count; ++k) any |= costs[k];
  return any == 0;
}

void LethalDistances::measure_row(const GridView& grid, int j) {
  if (!measure_along(grid.costs + grid.index({window_.i0, j}), one_row_.data())) return;
  for (int strip = 0; strip < strips_; ++strip) {
    const std::size_t k = index(strip, j);
    const Square* from = one_row_.data() + static_cast<std::size_t>(strip) * kColumns;
    near_[k] = std::any_of(from, from + kColumns, [](Square square) { return square < kNone; }) ? 1 : 0;
    if (near_[k] != 0) std::copy_n(from, kColumns, along_.data() + k * kColumns);
  }
}

// From one lethal cell to the next; false where there is none.
bool LethalDistances::measure_along(const std::uint8_t* costs, Square* squares) const {
  const int width = window_.width();
  const auto next_lethal = [&](int from) {
    const void* found =
        from < width ? std::memchr(costs + from, cost::kLethal, static_cast<std::size_t>(width - from)) : nullptr;
    return found != nullptr ? static_cast<int>(static_cast<const std::uint8_t*>(found) - costs) : -1;
  };
  int lethal = next_lethal(0);
  if (lethal < 0) return false;
  std::fill_n(squares, strips_ * kColumns, kNone);
  for (int k = std::max(0, lethal - reach_); k < lethal; ++k) squares[k] = square(lethal - k);
  while (lethal >= 0) {
    const int next = next_lethal(lethal + 1);
    const int end = next >= 0 ? next : width, half = next >= 0 ? (lethal + next) / 2 : end - 1;
    squares[lethal] = 0;
    for (int k = lethal + 1; k <= std::min(half, lethal + reach_); ++k) squares[k] = square(k - lethal);
    for (int k = std::max(half + 1, end - reach_); k < end && next >= 0; ++k) squares[k] = square(end - k);
    lethal = next;
  }
  return true;
}

}  // namespace hidwa_local_planner
