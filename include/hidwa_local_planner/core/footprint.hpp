// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The robot's outline in its own frame, as a polygon or, where the corners say so, a circle about the origin.
class Footprint {
 public:
  Footprint() = default;
  /// Corners [m] in order, either way round. `radius` > 0 [m] makes it a circle.
  explicit Footprint(Polygon outline, double radius = 0.0);

  /// A circle where 12 or more corners lie at one distance from the origin (costmap_2d makes 16 of `robot_radius`),
  /// else the polygon; padded by `padding` [m].
  static Footprint from_outline(const Polygon& outline, double padding);

  /// Why the planner cannot use the footprint, and the remedy; null where it can.
  const char* fault() const;

  bool empty() const { return outline_.empty() && radius_ <= 0.0; }
  bool is_circle() const { return radius_ > 0.0; }
  double radius() const { return radius_; }                       // of the circle [m]; 0 for a polygon
  const Polygon& outline() const { return outline_; }             // robot frame [m]
  double inscribed_radius() const { return inscribed_; }          // [m]
  double circumscribed_radius() const { return circumscribed_; }  // [m]
  /// A side of a convex outline: its points p have normal . p = offset, those inside less.
  struct Side {
    Point normal;         // of length 1, outwards
    double offset = 0.0;  // [m]
  };
  /// Empty where the outline is not convex, or a circle.
  const std::vector<Side>& sides() const { return sides_; }
  /// From a point to the outline, exactly; negative inside. Robot frame [m].
  double distance_to(const Point& point) const;
  /// The same outline, every side moved outwards by `padding` [m], so that everything within `padding` of it lies
  /// inside. No corner goes farther than twice the padding: the tip of one sharper than 60 degrees is cut off,
  /// `padding` away from it, and a line becomes a rectangle. Where the padding closes a dent, or the outline crosses
  /// itself, it is the convex hull that is padded. An outline with a corner that is not a number or farther than 20 m
  /// stays as it is, see fault().
  Footprint padded(double padding) const;

 private:
  // From a corner to the next one.
  struct Edge {
    Point way;                  // [m]
    double per_squared_length;  // [1/m^2]; 0 where it has no length
  };
  const char* fault_of_corners() const;
  double squared_distance_to_edge(std::size_t i, const Point& point) const;
  double distance_to_convex(const Point& point) const;
  double distance_to_any(const Point& point) const;

  Polygon outline_;
  std::vector<Edge> edges_;  // of each corner
  std::vector<Side> sides_;
  double radius_ = 0.0;
  double inscribed_ = 0.0;
  double circumscribed_ = 0.0;
};

}  // namespace hidwa_local_planner
