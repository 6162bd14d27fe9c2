// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_attack {

using hidwa_local_planner::Pose2;

struct Spot {
  double x = 0.0;  // [m]
  double y = 0.0;  // [m]
};

/// The robot's outline in its own frame: a convex polygon, counter-clockwise, or a circle about the origin.
struct Shape {
  std::vector<Spot> corners;  // [m]; empty for a circle
  double radius = 0.0;        // of the circle [m]; 0 for a polygon
};

enum class Outline { octagon, long_rectangle, off_centre, circle };
const char* name_of(Outline outline);
Shape shape_of(Outline outline);

/// Every side moved outwards by `by` [m]; corners where the moved sides meet, however sharp.
Shape padded(const Shape& shape, double by);
/// The farthest and the nearest point of its edge from the origin [m].
double outermost(const Shape& shape);
double innermost(const Shape& shape);
/// What a costmap is told of it: the corners, 16 of them for a circle.
std::vector<Spot> told_corners(const Shape& shape);

/// A shape at a pose.
class Placed {
 public:
  Placed(const Shape& shape, const Pose2& pose);
  /// How deep it lies in the square with this lower left corner [m]: the shortest way that parts them. Negative where
  /// they are apart: no farther than that they surely may approach.
  double depth_in(double x, double y, double side) const;
  Spot low() const { return low_; }
  Spot high() const { return high_; }

 private:
  double polygon_depth(double x, double y, double side) const;
  double circle_depth(double x, double y, double side) const;

  struct Side {
    Spot normal;                     // of length 1
    double least = 0.0, most = 0.0;  // of the corners along it [m]
  };
  double radius_;  // [m]
  Spot centre_, low_, high_;
  std::vector<Side> sides_;
};

}  // namespace hidwa_attack
