// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/grid_view.hpp"
#include "support/naive_collision.hpp"

namespace hidwa_local_planner::test {

/// The robot in a map: at a pose, the obstacle cells within its bounds are tried one by one.
class NaiveFootprint {
 public:
  NaiveFootprint(const GridView& grid, const NaiveBody& body, bool unknown_is_obstacle);

  bool collides(const Pose2& pose) const;
  double outer_radius() const { return outer_radius_; }  // [m]

 private:
  bool obstacle(Cell cell) const;
  bool disc_collides(const Pose2& pose) const;
  bool polygon_collides(const Pose2& pose) const;

  GridView grid_;
  NaiveBody body_;
  bool unknown_is_obstacle_;
  double outer_radius_;
  mutable Polygon placed_;  // kept for its memory
};

}  // namespace hidwa_local_planner::test
