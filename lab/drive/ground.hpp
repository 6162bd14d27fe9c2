// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "sim/disc_field.hpp"
#include "sim/distance_field.hpp"
#include "sim/grid_route.hpp"
#include "sim/occupancy_map.hpp"
#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace drive {

/// A map, where given discs that stand in it and are in no grid, and what is worked out of it once for all drives on
/// it. Drives in several threads may share it.
class Ground {
 public:
  explicit Ground(std::shared_ptr<const sim::OccupancyMap> map, std::shared_ptr<const sim::DiscField> discs = nullptr);

  const std::shared_ptr<const sim::OccupancyMap>& map() const { return map_; }
  const std::shared_ptr<const sim::DiscField>& discs() const { return discs_; }  // null: none

  /// Distance from (x, y) in direction `angle` [rad] to the first obstacle [m]; infinite if none within `range_max`
  /// [m].
  double range(double x, double y, double angle, double range_max) const;

  /// Free space between a robot's outline (robot frame) at `pose` (map frame) and the nearest obstacle [m]:
  /// exact below `at_most` [m], else `at_most`; 0 where they overlap.
  double clearance(const sim::Polygon& outline, const sim::Pose& pose, double at_most) const;

 private:
  double clearance_of_map(const sim::Polygon& outline, const sim::Pose& pose, double at_most) const;

  std::shared_ptr<const sim::OccupancyMap> map_;
  std::shared_ptr<const sim::DiscField> discs_;
  sim::DistanceField distance_;
};

/// The clearance by which a navfn plans on a costmap with this inflation.
/// `inscribed_radius` [m], `cost_scaling_factor` [1/m].
sim::RouteClearance navfn_clearance(double inscribed_radius, double cost_scaling_factor);

}  // namespace drive
}  // namespace hidwa_local_planner
