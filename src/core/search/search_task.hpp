// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/motion/velocity_limits.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/moving_obstacle.hpp"
#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner {

/// A part of a map, with its own copy of the costs.
struct MapCopy {
  std::vector<std::uint8_t> costs;  // [size_x * size_y] of costmap_2d
  int size_x = 0, size_y = 0;       // [cells]
  double resolution = 0.05;         // [m]
  double origin_x = 0.0;            // lower left corner, costmap frame [m]
  double origin_y = 0.0;            // [m]

  GridView view() const { return {costs.data(), size_x, size_y, resolution, origin_x, origin_y}; }
  /// The costs fit the size, and a robot may drive on such cells. Damaged bytes may hold anything.
  bool plausible() const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.costs, self.size_x, self.size_y, self.resolution, self.origin_x, self.origin_y);
  }
};

/// What a search for a way is about: a snapshot of the map around the robot, the robot, and where it has to come. It is
/// all that a search depends on, so that a search can be repeated from it.
struct SearchTask {
  static constexpr double kAnyHeading = 4.0;  // more than pi [rad]
  MapCopy map;
  bool unknown_is_obstacle = true;
  Pose2 start;                       // the robot stands there, costmap frame
  Polygon outline;                   // with its padding, robot frame [m]; empty for a circle
  double radius = 0.0;               // of a circle, with its padding [m]
  double forward = 0.0;              // speeds that the way is timed by, positive; 0 where it cannot [m/s]
  double backward = 0.0;             // [m/s]
  double turning = 0.0;              // [rad/s]
  std::vector<Point> target;         // the plan's part that the way has to come to, costmap frame [m]
  double near_target = 0.0;          // tolerance to one of its points [m]
  double heading = 0.0;              // that it has to end with [rad]
  double heading_off = kAnyHeading;  // by no more than that [rad]

  GridView grid() const { return map.view(); }
  Footprint footprint() const { return Footprint(outline, radius); }
  bool operator==(const SearchTask& other) const;
  /// It can be searched. Damaged bytes may hold anything.
  bool plausible() const;

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.map, self.unknown_is_obstacle, self.start, self.outline, self.radius, self.forward, self.backward,
       self.turning, self.target, self.near_target, self.heading, self.heading_off);
  }
};

/// Makes obstacles of what moves, where it is now: all of it but what overlaps the robot at the start.
void add_movers(const MovingObstacleEstimates& movers, const Footprint& footprint, SearchTask& task);
/// As if they were not there: what is within 0.1 m of their edge is theirs.
void remove_movers(const MovingObstacleEstimates& movers, SearchTask& task);
/// The task of a robot at `start`. The target is the plan from 1.5 m to 2.5 m beyond its pose nearest to the start, as
/// far as it lies on the map, or its end where that is nearer. Keeps the memory of `task`.
void make_search_task(const Pose2& start, const std::vector<Pose2>& plan, const GridView& grid,
                      const Footprint& footprint, const Parameters& parameters, const VelocityLimits& limits,
                      SearchTask& task);

/// Makes the goal's pose the target of a task that make_search_task() has made: well within both tolerances.
void aim_at_goal(const Pose2& goal, const Parameters& parameters, SearchTask& task);

}  // namespace hidwa_local_planner
