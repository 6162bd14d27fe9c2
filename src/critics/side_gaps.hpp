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
  /// Places are padded to a whole number of these.
  static constexpr std::size_t kPad = 4;

  void reserve(std::size_t places, std::size_t sides, std::size_t discs);
  /// Where the outline is: `x`, `y` [places, a multiple of kPad], in the frame in which the heading is [m]. It must
  /// have sides. No disc is there yet.
  void place(const Footprint& footprint, double cosine, double sine, const std::vector<double>& x,
             const std::vector<double>& y);
  void add(const Point& centre, double radius);
  /// [places] to the nearest disc; no less than `least` and its radius [m].
  void measure(double least, std::vector<double>& gaps) const;

 private:
  struct Normal {
    double x, y;
  };
  std::vector<Normal> normals_;  // of the sides, turned
  std::vector<double> along_;    // [sides * places] along a side's normal, from the frame's origin to the side [m]
  std::vector<double> points_;   // [discs * sides] along a side's normal, from the frame's origin to the centre [m]
  std::vector<double> radii_;    // [m]
  std::size_t places_ = 0;
};

}  // namespace hidwa_local_planner::critics
