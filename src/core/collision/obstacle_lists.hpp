// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/collision/bit_grid.hpp"
#include "core/collision/outline_planes.hpp"
#include "core/util/rotation.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// For every cell the robot's centre may be in, the obstacle cells that an outline there comes near: collected when
/// first asked for, so that many poses in a cell share the search.
class ObstacleLists {
 public:
  /// Marks of the window's cells: `solid` ones no part of the robot may enter, `core` ones only its centre may not.
  /// `solid_reach` and `core_reach` [m] say how near counts. All must outlive the questions; `core` may be null.
  struct Window {
    const BitGrid* solid = nullptr;
    const BitGrid* core = nullptr;
    double solid_reach = 0.0, core_reach = 0.0;
    double corner_x = 0.0, corner_y = 0.0;  // of the window's first cell [m]
    double resolution = 0.05;               // [m]
  };
  void prepare(const Window& window);
  /// The window has moved, but it shows the same cells: the lists stay valid.
  void move_to(double corner_x, double corner_y);

  /// How far a convex outline, or a circle, at a pose in cell (i, j) of the window is from the nearest obstacle [m], at
  /// least and up to `cap`; not positive where it overlaps one.
  double smallest_gap(int i, int j, const Pose2& pose, const Rotation& heading, const Footprint& outline, double cap);

 private:
  struct Span {
    std::uint32_t first = 0;
    std::uint32_t solid = 0, core = 0;  // so many of each, one after the other
    bool known = false;
  };
  const Span& span_of(int i, int j);
  void collect(const BitGrid& marks, int i, int j, const std::vector<int>& reach);
  double gap_of_polygon(const Span& span, const Pose2& pose, const Rotation& heading, const Footprint& outline,
                        double cap);
  double gap_of_circle(const Span& span, const Pose2& pose, double radius, double cap) const;

  Window window_;
  std::vector<int> solid_reach_, core_reach_;  // columns by row, see disc_reach()
  std::vector<Span> spans_;                    // of the window's cells
  std::vector<double> x_, y_;                  // centres of the cells in all lists, from the window's corner [m]
  OutlinePlanes planes_;
};

/// How many columns away a cell in a row `dy` rows away can be and still be nearer than `radius`, by rows, when each of
/// the two cells is nearer by `slack` cells an axis than its index says.
void disc_reach(double radius, double resolution, int slack, std::vector<int>& reach);

}  // namespace hidwa_local_planner
