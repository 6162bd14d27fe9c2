// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hidwa_local_planner {

/// A grid of bits, 64 cells a word, that can be dilated by a disc-like shape a row at a time.
class BitGrid {
 public:
  void reset(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }
  void set(int i, int j) { words_[word(i, j)] |= std::uint64_t{1} << (i & 63); }
  bool test(int i, int j) const { return (words_[word(i, j)] >> (i & 63)) & 1U; }
  /// True when any bit of row j in [i0, i1] is set; the range must lie inside.
  bool any(int j, int i0, int i1) const;

  /// Sets every bit of `out` whose cell has a set bit of this grid at an offset (dx, dy) with |dx| <= reach[|dy|].
  /// `reach` must not grow with |dy|; a negative reach ends it. `out` gets this grid's size.
  void dilate(const std::vector<int>& reach, BitGrid& out) const;

 private:
  std::size_t word(int i, int j) const {
    return static_cast<std::size_t>(j) * row_words_ + (static_cast<std::size_t>(i) >> 6);
  }
  void widen(std::vector<std::uint64_t>& row, std::vector<std::uint64_t>& scratch) const;

  int width_ = 0, height_ = 0;
  std::size_t row_words_ = 0;
  std::vector<std::uint64_t> words_;
  mutable std::vector<std::uint64_t> row_, scratch_;
};

}  // namespace hidwa_local_planner
