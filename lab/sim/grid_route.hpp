// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "sim/distance_field.hpp"
#include "sim/occupancy_map.hpp"

namespace hidwa_local_planner {
namespace sim {

/// A way through the map: points [m], map frame.
using Route = std::vector<Eigen::Vector2d>;

/// How a route keeps clear of obstacles.
struct RouteClearance {
  double robot_radius = 0.30;        // [m], cells nearer to an obstacle are not passed
  double cost_scaling_factor = 5.0;  // [1/m], how fast the cost of being near falls off
  double weight = 4.0;               // cost of a metre along the limit, in metres more than one in the open
};

/// Cost of passing at `distance` [m] from an obstacle: 1 at the robot's radius or nearer, then falling off
/// exponentially, as inflation layers of costmaps have it.
double inflation_cost(double distance, const RouteClearance& clearance);

/// Shortest ways with clearance from anywhere to one goal: Dijkstra's algorithm from the goal over the
/// 8-connected grid, once; each route then only follows the way found.
class GridRoute {
 public:
  /// For one `start` alone, where it is given: the search ends when its way is found.
  GridRoute(const OccupancyMap& map, const RouteClearance& clearance, const Eigen::Vector2d& goal,
            const std::optional<Eigen::Vector2d>& start = std::nullopt);

  /// From `start` to the goal, one point a cell; empty where there is no way. A start too near to an obstacle
  /// is served from the nearest cell within 0.5 m that has a way.
  Route from(const Eigen::Vector2d& start) const;

 private:
  // Ends early at the cell `last`, where it is one.
  void search(const DistanceField& field, const RouteClearance& clearance, int goal_column, int goal_row,
              std::size_t last);
  bool reached(int column, int row) const;
  bool find_start(int& column, int& row) const;

  GridGeometry map_;
  std::vector<std::uint8_t> toward_goal_;  // index of the neighbour to go to; kNone: no way; kGoal: arrived
};

/// Length of the line through the points [m].
double length(const Route& route);

/// The same line with points every `spacing` [m] and the end.
Route resampled(const Route& route, double spacing);

}  // namespace sim
}  // namespace hidwa_local_planner
