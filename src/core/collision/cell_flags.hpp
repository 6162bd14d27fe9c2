// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hidwa_local_planner {

/// A grid of cells with a byte of flags each. A flag can be spread around the cells that have another one, a row at a
/// time. Outside the grid no cell has any flag.
class CellFlags {
 public:
  /// No cell has any flag.
  void reset(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }
  /// The flags of row j [width].
  std::uint8_t* row(int j) { return flags_.data() + start_of(j); }
  const std::uint8_t* row(int j) const { return flags_.data() + start_of(j); }
  std::uint8_t at(int i, int j) const { return row(j)[i]; }
  /// From one row to the next.
  std::size_t stride() const { return stride_; }

  /// The first cell of row j in [i0, i1] with the flag; beyond i1 where there is none.
  int find(std::uint8_t flag, int j, int i0, int i1) const;
  /// The same size, and the same cells with each of these flags.
  bool same(const CellFlags& other, std::uint8_t flags) const;

  /// Sets the flag `to` in every cell that has one with `from` at an offset (dx, dy), |dx| <= reach[|dy|]. `reach` must
  /// not be negative nor grow with |dy|; beyond its end nothing is reached.
  void spread(std::uint8_t from, const std::vector<int>& reach, std::uint8_t to);
  /// Sets the flag `edge` in the cells with `of` that have one without it above, below, left or right of them.
  void mark_edges(std::uint8_t of, std::uint8_t edge);

 private:
  // A border all around, which has no flag that is looked for, needs no bounds test: a row above and one below, and a
  // cell at least between the end of a row and the begin of the next.
  std::size_t start_of(int j) const { return static_cast<std::size_t>(j + 1) * stride_; }

  int width_ = 0, height_ = 0;
  std::size_t stride_ = 0;
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint8_t> row_, wider_;  // of a row that is spread, with a cell more at both ends
};

}  // namespace hidwa_local_planner
