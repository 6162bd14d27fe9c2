// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace sim {

/// Upright cylinders of one radius, exactly: nothing is drawn into a grid. Several threads may ask at once.
class DiscField {
 public:
  /// `centres` in the map frame [m], `radius` [m]. Throws std::invalid_argument where the radius is not
  /// positive or a centre is no number.
  DiscField(std::vector<Eigen::Vector2d> centres, double radius);

  /// Whether a simple polygon (map frame) shares area with a disc.
  bool overlaps(const Polygon& polygon) const { return gap(polygon, kTouching) <= 0.0; }

  /// Free space between a polygon and the nearest disc [m], exact below `at_most` [m], else that; 0 where
  /// they overlap.
  double gap(const Polygon& polygon, double at_most) const;

  /// Free space between a point and the nearest disc [m], as above; negative inside a disc.
  double distance(const Eigen::Vector2d& point, double at_most) const;

  /// Distance from (x, y) in direction `angle` [rad] to where the ray meets the first disc [m]; infinite if
  /// none within `range_max` [m]; 0 inside a disc.
  double range(double x, double y, double angle, double range_max) const;

 private:
  static constexpr double kTouching = 1e-9;  // [m]

  std::vector<Eigen::Vector2d> centres_;
  double radius_;
};

}  // namespace sim
}  // namespace hidwa_local_planner
