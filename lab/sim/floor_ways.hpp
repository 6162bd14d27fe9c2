// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/distance_field.hpp"
#include "sim/grid_route.hpp"
#include "sim/occupancy_map.hpp"

namespace hidwa_local_planner {
namespace sim {

/// Places on a floor where people go, and the ways to them. Made once; several drives and threads may share it.
class FloorWays {
 public:
  /// `places` in the map frame [m]. Ways keep `clearance` [m] from walls. Throws std::invalid_argument where there are
  /// not two places, or one of them cannot be reached from the first.
  FloorWays(const OccupancyMap& map, std::vector<Eigen::Vector2d> places, double clearance);

  std::size_t places() const { return places_.size(); }
  const Eigen::Vector2d& place(std::size_t index) const { return places_[index]; }

  /// From `start` to a place; empty where there is no way.
  Route way(const Eigen::Vector2d& start, std::size_t place) const { return ways_[place].from(start); }

  /// From a point to the nearest wall [m], about a cell exact.
  double wall_distance(const Eigen::Vector2d& point) const { return walls_.at(point.x(), point.y()); }
  /// Unit vector away from that wall; zero where there is no slope.
  Eigen::Vector2d away_from_wall(const Eigen::Vector2d& point) const;

 private:
  double step_;  // [m], of the slope
  DistanceField walls_;
  std::vector<Eigen::Vector2d> places_;
  std::vector<GridRoute> ways_;  // to each place
};

/// `count` places that can be reached from `start` [m] with `clearance` [m]: every second one within kBeside of the
/// `robot_way`, where one is given, so that people and robot meet; the others anywhere.
std::vector<Eigen::Vector2d> choose_places(const OccupancyMap& map, const Eigen::Vector2d& start,
                                           const Route& robot_way, std::size_t count, double clearance,
                                           std::uint64_t seed);
constexpr double kBeside = 2.0;  // [m]

}  // namespace sim
}  // namespace hidwa_local_planner
