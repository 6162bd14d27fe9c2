// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "hidwa_local_planner/core/footprint.hpp"

namespace hidwa_local_planner::critics {

/// How far discs are from a convex outline at several places with one heading: from the side that is farthest in front
/// of the disc. Off a corner that is a little less than the distance.
class SideGaps {
 public:
  struct Disc {
    double x, y;    // [m]
    double radius;  // [m]
  };
  /// Places are padded to a whole number of these.
  static constexpr std::size_t kPad = 4;

  void reserve(std::size_t places, std::size_t sides);
  /// How the outline is turned. It must have sides.
  void turn(const Footprint& footprint, double cosine, double sine);
  /// [places] from the outline at (x, y) to the nearest of the discs, of which there is one at least; no less than
  /// `least` and its radius [m]. `x`, `y` [places, a multiple of kPad] [m].
  void measure(const std::vector<double>& x, const std::vector<double>& y, const std::vector<Disc>& discs, double least,
               std::vector<double>& gaps);

 private:
  std::vector<double> normal_x_, normal_y_, offset_;  // [sides]
  std::vector<double> along_;  // [sides * places] along a side's normal, from the frame's origin to the side [m]
};

}  // namespace hidwa_local_planner::critics
