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
  /// Sets the bits of row j in [i0, i1).
  void fill(int j, int i0, int i1);
  /// Sets the bits of row j in [i0, i1) where `cells`, which begin at i0, hold one value or the other.
  void set_where(int j, int i0, int i1, const std::uint8_t* cells, std::uint8_t one, std::uint8_t other);
  /// 64 bits as 64 bytes of 0 or 1, the lowest first.
  static void unpack(std::uint64_t bits, std::uint8_t* flags);
  bool test(int i, int j) const { return (words_[word(i, j)] >> (i & 63)) & 1U; }
  /// The same size and the same bits.
  bool operator==(const BitGrid& other) const {
    return width_ == other.width_ && height_ == other.height_ && words_ == other.words_;
  }
  /// True when any bit of row j in [i0, i1] is set; the range must lie inside.
  bool any(int j, int i0, int i1) const;
  /// The 64 bits of row j from column i0 on, the first one lowest; 0 beyond the row's words.
  std::uint64_t bits(int j, int i0) const {
    const std::size_t w = word(i0, j), end = static_cast<std::size_t>(j + 1) * row_words_;
    const int shift = i0 & 63;
    const std::uint64_t low = words_[w] >> shift;
    return shift == 0 || w + 1 >= end ? low : low | (words_[w + 1] << (64 - shift));
  }

  /// Sets every bit of `out` whose cell has a set bit of this grid at an offset (dx, dy) with |dx| <= reach[|dy|].
  /// `reach` must not grow with |dy|; a negative reach ends it. `out` gets this grid's size.
  void dilate(const std::vector<int>& reach, BitGrid& out) const;
  /// As dilate(), keeping what is set in `out`, which must have this grid's size.
  void dilate_into(const std::vector<int>& reach, BitGrid& out) const;
  /// Sets the bits of `out` that are set here with a bit above, below, left or right of them that is not, or at the
  /// rim.
  void find_edges(BitGrid& out) const;

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
