// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/cell_flags.hpp"

#include <cstring>
#include <utility>

namespace hidwa_local_planner {
namespace {

// Rows are whole registers, so that loops over them have no remainder.
constexpr std::size_t kRegister = 32;

// `to` for each cell with `from`, and whether there is any.
bool take_flag(const std::uint8_t* __restrict cells, std::uint8_t from, std::uint8_t to, std::size_t count,
               std::uint8_t* __restrict taken) {
  std::uint8_t any = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t flag = (cells[i] & from) != 0 ? to : std::uint8_t{0};
    taken[i] = flag;
    any = static_cast<std::uint8_t>(any | flag);
  }
  return any != 0;
}

// One cell wider on both sides.
void widen_row(const std::uint8_t* __restrict row, std::size_t count, std::uint8_t* __restrict wider) {
  for (std::size_t i = 1; i <= count; ++i) wider[i] = static_cast<std::uint8_t>(row[i - 1] | row[i] | row[i + 1]);
}

void add_flags(const std::uint8_t* __restrict flags, std::size_t count, std::uint8_t* __restrict cells) {
  for (std::size_t i = 0; i < count; ++i) cells[i] = static_cast<std::uint8_t>(cells[i] | flags[i]);
}

// `edge` for each cell with `of` that has not got four neighbours with it.
void take_edges(const std::uint8_t* cells, std::size_t stride, std::uint8_t of, std::uint8_t edge, std::size_t count,
                std::uint8_t* __restrict taken) {
  const std::uint8_t *left = cells - 1, *right = cells + 1, *below = cells - stride, *above = cells + stride;
  for (std::size_t i = 0; i < count; ++i) {
    const int around = left[i] & right[i] & below[i] & above[i];
    taken[i] = (cells[i] & ~around & of) != 0 ? edge : std::uint8_t{0};
  }
}

}  // namespace

void CellFlags::reset(int width, int height) {
  width_ = width;
  height_ = height;
  stride_ = (static_cast<std::size_t>(width) / kRegister + 1) * kRegister;
  flags_.assign(stride_ * (static_cast<std::size_t>(height) + 2), 0);
  row_.assign(stride_ + 2, 0);
  wider_.assign(stride_ + 2, 0);
}

int CellFlags::find(std::uint8_t flag, int j, int i0, int i1) const {
  const std::uint8_t* cells = row(j);
  const std::uint64_t in_each = flag * std::uint64_t{0x0101010101010101U};
  int i = i0;
  while (i <= i1) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, cells + i, sizeof(eight));
    if ((eight & in_each) == 0) {
      i += 8;
    } else if ((cells[i] & flag) != 0) {
      return i;
    } else {
      ++i;
    }
  }
  return i1 + 1;
}

bool CellFlags::same(const CellFlags& other, std::uint8_t flags) const {
  if (width_ != other.width_ || height_ != other.height_) return false;
  std::uint8_t differ = 0;
  for (std::size_t k = 0; k < flags_.size(); ++k) {
    differ = static_cast<std::uint8_t>(differ | (flags_[k] ^ other.flags_[k]));
  }
  return (differ & flags) == 0;
}

void CellFlags::spread(std::uint8_t from, const std::vector<int>& reach, std::uint8_t to) {
  for (int j = 0; j < height_; ++j) {
    if (!take_flag(row(j), from, to, stride_, row_.data() + 1)) continue;
    int widened = 0;
    // From the far rows, which reach least, to the row itself: each widening serves all that follow.
    for (int dy = static_cast<int>(reach.size()) - 1; dy >= 0; --dy) {
      for (; widened < reach[static_cast<std::size_t>(dy)]; ++widened) {
        widen_row(row_.data(), stride_, wider_.data());
        std::swap(row_, wider_);
      }
      for (const int target : {j - dy, j + dy}) {
        if (target >= 0 && target < height_) add_flags(row_.data() + 1, stride_, row(target));
      }
    }
  }
}

void CellFlags::mark_edges(std::uint8_t of, std::uint8_t edge) {
  for (int j = 0; j < height_; ++j) {
    take_edges(row(j), stride_, of, edge, stride_, row_.data() + 1);
    add_flags(row_.data() + 1, stride_, row(j));
  }
}

}  // namespace hidwa_local_planner
