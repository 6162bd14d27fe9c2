// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace hidwa_local_planner {

struct Tile;
class TileScores;

/// What a distance is measured to: around obstacles, or as Nav2's map grids measure it, as the parameter `map_grid`
/// says.
struct PlanDistance {
  enum class To { path, goal };
  To to = To::path;
  double ahead = 0.0;  // goal only: it is moved so far along the bearing from the robot to the final goal [m]

  /// To the part of the plan that lies on the local map.
  static PlanDistance to_path() { return {}; }
  /// To the local goal: the last pose of that part.
  static PlanDistance to_goal(double ahead = 0.0) { return {To::goal, ahead}; }
};

/// What the planner knows about the map around a tile's candidates, for critics. Critics ask for a whole tile at once;
/// Tile and CycleView have the questions as functions of their own. `found` has room for tile.count values.
class Surroundings {
 public:
  virtual ~Surroundings() = default;

  /// False where no pose of the plan lies on the local map: then no distance is known.
  virtual bool plan_on_map() const = 0;
  /// Makes a distance ready that will be asked for. Without it every answer is the same, and slower.
  virtual void expect(const PlanDistance& distance) = 0;
  /// Distances [m] from the points `forward` [m] ahead of the last poses. Where such a point has none (`map_grid:
  /// geodesic`: or lies on a lethal or inscribed cell) the robot's centre counts instead; not with `map_grid: l1`.
  /// Negative where there is no way, and for candidates that are rejected already. True when none is negative.
  virtual bool distances(const Tile& tile, const PlanDistance& distance, double forward, const TileScores& scores,
                         double* found) = 0;
  /// The costs of the cells under the robot's centre in a step, 0 to 255; 0 beyond the map.
  virtual void costs(const Tile& tile, std::size_t step, double* found) = 0;
  /// The distances [m] by which every point of the robot may move in any direction from its pose in a step and touch no
  /// obstacle: lower bounds, at most two cells; 0 where its outline touches one.
  virtual void clearances(const Tile& tile, std::size_t step, double* found) = 0;

 protected:
  Surroundings() = default;
  Surroundings(const Surroundings&) = default;
  Surroundings& operator=(const Surroundings&) = default;
};

}  // namespace hidwa_local_planner
