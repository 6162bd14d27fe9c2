// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"

namespace hidwa_local_planner {
namespace drive {

/// A square grid of costs that follows the robot by whole cells and keeps what it knows, as a rolling costmap
/// of costmap_2d does: cells that come in are free.
class RollingGrid {
 public:
  /// Its lower left corner lies at the frame's origin. `width` and `resolution` in [m].
  RollingGrid(double width, double resolution);

  /// Moves the grid so that (x, y) [m] lies in its middle, by whole cells towards it.
  void follow(double x, double y);

  GridView view() const;
  int cells() const { return cells_; }  // along a side
  double resolution() const { return resolution_; }
  double origin_x() const { return column_ * resolution_; }  // [m]
  double origin_y() const { return row_ * resolution_; }     // [m]
  std::uint8_t* row(int j) { return costs_.data() + index(0, j); }
  const std::uint8_t* row(int j) const { return costs_.data() + index(0, j); }

  /// Puts every cell of another grid's place and geometry.
  void take_place_of(const RollingGrid& other);

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(cells_) + static_cast<std::size_t>(i);
  }

  int cells_;
  double resolution_;  // [m]
  int column_ = 0;     // of the lower left corner, in cells from the frame's origin
  int row_ = 0;
  std::vector<std::uint8_t> costs_;
  std::vector<std::uint8_t> moved_;
};

}  // namespace drive
}  // namespace hidwa_local_planner
