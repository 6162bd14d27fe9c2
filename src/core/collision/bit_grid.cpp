// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/bit_grid.hpp"

#include <algorithm>

namespace hidwa_local_planner {
namespace {

// The lowest bits of 64 bytes, the first one's lowest. Eight at a time: a factor that brings bit 8 k to bit 56 + k.
std::uint64_t pack(const std::uint8_t* flags) {
  std::uint64_t bits = 0;
  for (int group = 0; group < 8; ++group) {
    std::uint64_t bytes = 0;
    for (int k = 0; k < 8; ++k) bytes |= std::uint64_t{flags[8 * group + k]} << (8 * k);
    bits |= ((bytes * 0x0102040810204080U) >> 56) << (8 * group);
  }
  return bits;
}

}  // namespace

void BitGrid::reset(int width, int height) {
  width_ = width;
  height_ = height;
  row_words_ = (static_cast<std::size_t>(width) + 63) / 64;
  words_.assign(row_words_ * static_cast<std::size_t>(height), 0);
}

void BitGrid::fill(int j, int i0, int i1) {
  for (int i = i0; i < i1; ++i) set(i, j);
}

void BitGrid::set_where(int j, int i0, int i1, const std::uint8_t* cells, std::uint8_t one, std::uint8_t other) {
  for (int i = i0; i < i1;) {
    const int end = std::min(i1, (i | 63) + 1);
    const std::uint8_t* from = cells + (i - i0);
    const int count = end - i;
    std::uint8_t flags[64] = {};
    std::uint8_t* flag = flags + (i & 63);
    for (int k = 0; k < count; ++k) flag[k] = static_cast<std::uint8_t>((from[k] == one) | (from[k] == other));
    words_[word(i, j)] |= pack(flags);
    i = end;
  }
}

void BitGrid::unpack(std::uint64_t bits, std::uint8_t* flags) {
  for (int group = 0; group < 8; ++group) {
    // One bit a byte, then down to the lowest.
    const std::uint64_t spread = (((bits >> (8 * group)) & 0xFF) * 0x0101010101010101U) & 0x8040201008040201U;
    const std::uint64_t bytes = ((spread + 0x7F7F7F7F7F7F7F7FU) >> 7) & 0x0101010101010101U;
    for (int k = 0; k < 8; ++k) flags[8 * group + k] = static_cast<std::uint8_t>(bytes >> (8 * k));
  }
}

bool BitGrid::any(int j, int i0, int i1) const {
  for (int i = i0; i <= i1; i = (i | 63) + 1) {
    const int last = std::min(i1, i | 63);
    const std::uint64_t up_to = (last & 63) == 63 ? ~std::uint64_t{0} : (std::uint64_t{1} << ((last & 63) + 1)) - 1;
    const std::uint64_t from = ~std::uint64_t{0} << (i & 63);
    if ((words_[word(i, j)] & up_to & from) != 0) return true;
  }
  return false;
}

// One cell wider on both sides. Bits beyond the width may get set; nobody reads them.
void BitGrid::widen(std::vector<std::uint64_t>& row, std::vector<std::uint64_t>& scratch) const {
  scratch = row;
  for (std::size_t w = 0; w < row_words_; ++w) {
    std::uint64_t bits = scratch[w] | (scratch[w] << 1) | (scratch[w] >> 1);
    if (w > 0) bits |= scratch[w - 1] >> 63;
    if (w + 1 < row_words_) bits |= scratch[w + 1] << 63;
    row[w] = bits;
  }
}

void BitGrid::dilate(const std::vector<int>& reach, BitGrid& out) const {
  out.reset(width_, height_);
  dilate_into(reach, out);
}

void BitGrid::dilate_into(const std::vector<int>& reach, BitGrid& out) const {
  if (reach.empty() || reach[0] < 0) return;
  row_.resize(row_words_);
  for (int j = 0; j < height_; ++j) {
    const auto begin = words_.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(j) * row_words_);
    if (std::all_of(begin, begin + static_cast<std::ptrdiff_t>(row_words_), [](std::uint64_t w) { return w == 0; })) {
      continue;
    }
    std::copy(begin, begin + static_cast<std::ptrdiff_t>(row_words_), row_.begin());
    int widened = 0;
    // From the far rows, which reach least, to the row itself: each widening serves all that follow.
    for (int dy = static_cast<int>(reach.size()) - 1; dy >= 0; --dy) {
      if (reach[static_cast<std::size_t>(dy)] < 0) continue;
      for (; widened < reach[static_cast<std::size_t>(dy)]; ++widened) widen(row_, scratch_);
      for (const int row : {j - dy, j + dy}) {
        if (row < 0 || row >= height_) continue;
        std::uint64_t* target = out.words_.data() + static_cast<std::size_t>(row) * row_words_;
        for (std::size_t w = 0; w < row_words_; ++w) target[w] |= row_[w];
      }
    }
  }
}

void BitGrid::find_edges(BitGrid& out) const {
  out.reset(width_, height_);
  for (int j = 0; j < height_; ++j) {
    const std::size_t first = static_cast<std::size_t>(j) * row_words_;
    for (std::size_t w = first; w < first + row_words_; ++w) {
      if (words_[w] == 0) continue;
      std::uint64_t surrounded = 0;
      if (j > 0 && j + 1 < height_) {
        const std::uint64_t before = w > first ? words_[w - 1] >> 63 : 0;
        const std::uint64_t after = w + 1 < first + row_words_ ? words_[w + 1] << 63 : 0;
        surrounded =
            ((words_[w] << 1) | before) & ((words_[w] >> 1) | after) & words_[w - row_words_] & words_[w + row_words_];
      }
      out.words_[w] = words_[w] & ~surrounded;
    }
  }
}

}  // namespace hidwa_local_planner
