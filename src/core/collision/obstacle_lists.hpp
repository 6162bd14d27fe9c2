// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/collision/cell_flags.hpp"
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
  /// The window's cells, which must outlive the questions: those with the flag `solid` no part of the robot may enter,
  /// those with the flag `core`, where it is not 0, only its centre may not. `solid_reach` and `core_reach` [m] say how
  /// near counts.
  struct Window {
    const CellFlags* cells = nullptr;
    std::uint8_t solid = 0, core = 0;
    double solid_reach = 0.0, core_reach = 0.0;
    Point corner{0.0, 0.0};    // of the first cell [m]
    double resolution = 0.05;  // [m]
  };
  void prepare(const Window& window);
  /// The window has moved, but it shows the same cells: the lists stay valid.
  void move_to(const Point& corner);

  /// How far a convex outline, or a circle, at a pose in a cell of the window is from the nearest obstacle [m], at
  /// least and up to `cap`; not positive where it overlaps one.
  double smallest_gap(Cell cell, const Pose2& pose, const Rotation& heading, const Footprint& outline, double cap);

 private:
  struct Span {
    std::uint32_t first = 0;
    std::uint32_t solid = 0, core = 0;  // so many of each, one after the other
    bool known = false;
  };
  const Span& span_of(Cell cell);
  void collect(std::uint8_t flag, Cell around, const std::vector<int>& reach);
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
