// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "support/naive_gap.hpp"

namespace hidwa_local_planner::test {

/// The robot in a map: at a pose, the obstacle cells within its bounds are tried one by one.
class NaiveFootprint {
 public:
  NaiveFootprint(const GridView& grid, const NaiveBody& body, bool unknown_is_obstacle);

  bool collides(const Pose2& pose) const;
  /// Whether nothing is within `needed` [m] of the robot; its outline is convex, or a circle. None where it collides.
  bool keeps(const Pose2& pose, double needed) const;
  /// How far it is from the nearest obstacle [m], `most` where that is farther.
  double room(const Pose2& pose, double most) const;
  double outer_radius() const { return outer_radius_; }  // [m]

 private:
  bool obstacle(Cell cell) const;
  bool disc_collides(const Pose2& pose) const;
  bool polygon_collides(const Pose2& pose) const;
  void place(const Pose2& pose) const;

  GridView grid_;
  NaiveBody body_;
  bool unknown_is_obstacle_;
  double outer_radius_;
  mutable Polygon placed_;  // kept for its memory
  mutable std::vector<Point> axes_;
};

}  // namespace hidwa_local_planner::test
