// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/collision/outline_planes.hpp"
#include "core/util/rotation.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// How deep the robot's outline reaches into obstacle cells.
///
/// The depth in a cell is the length of the shortest move, in any direction, that takes outline and cell apart:
///   convex outline  the least overlap over the normals of both shapes' sides (separating axes). The shortest move
///                   of two convex polygons is always along one of these normals, so this is exact.
///   circle          radius - distance from the centre to the cell; from within the cell radius + distance to its
///                   nearest side. Exact.
///   other outlines  that of the convex hull where the outline itself shares area with the cell, else 0. Never less
///                   than the true depth, for a move that takes the hull out takes the outline out.
/// Where every point of the robot moves by d at most, the depth of a convex outline or a circle changes by d at most.
class OutlineDepth {
 public:
  /// Once a cycle. `resolution` [m] is a cell's side. `footprint` must outlive the questions.
  void prepare(const Footprint& footprint, double resolution);

  /// Depths [m] in `count` cells with the centres (x, y) [m]. Not positive where they share no area. Poses and centres
  /// have the same origin, best one near the robot: less rounding.
  void of(const Pose2& pose, const Rotation& heading, const double* x, const double* y, std::size_t count,
          double* depth);

 private:
  void make_hull();
  void drop_untouched(const Pose2& pose, const Rotation& heading, const double* x, const double* y, std::size_t count,
                      double* depth);
  double in_circle(double dx, double dy) const;

  const Footprint* footprint_ = nullptr;
  double half_ = 0.0;  // of a cell's side [m]
  Footprint hull_;     // of an outline that is not convex
  Polygon hull_from_;  // what it was made of
  const Footprint* convex_ = nullptr;
  OutlinePlanes planes_;
  Polygon corners_;  // of an outline that is not convex, placed
};

}  // namespace hidwa_local_planner
