// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace hidwa_local_planner {

struct Tile;
class TileScores;

/// What a distance is measured to: around obstacles, or as Nav2's map grids measure it, as the parameter `method`
/// says.
struct PlanDistance {
  enum class To { path, goal };
  To to = To::path;
  double ahead = 0.0;  // goal only: shift of the local goal along the bearing from the robot to the final goal. Where
                       // the plan turns back, the bearing is that to the local goal [m]

  /// To the part of the plan that lies on the local map.
  static PlanDistance to_path() { return {}; }
  /// To the local goal: the last pose of that part.
  static PlanDistance to_goal(double ahead = 0.0) { return {To::goal, ahead}; }
};

/// What critics can ask about the map around a tile's candidates. One call answers for a whole tile. Tile and CycleView
/// have functions of the same names. `found` has room for tile.count values.
class Surroundings {
 public:
  virtual ~Surroundings() = default;

  /// False where no pose of the plan lies on the local map: then no distance is known.
  virtual bool plan_on_map() const = 0;
  /// Announces that a distance will be asked for. Without it the answers are the same, but slower.
  virtual void expect(const PlanDistance& distance) = 0;
  /// Distances [m] from the points `forward` [m] ahead of the last poses. Where such a point has none (`method:
  /// hidwa`: or lies on a lethal or inscribed cell) the robot's centre counts instead; not with `method: paper`.
  /// Negative where there is no way, and for candidates that are rejected already. True when none is negative.
  virtual bool distances(const Tile& tile, const PlanDistance& distance, double forward, const TileScores& scores,
                         double* found) = 0;
  /// The costs of the cells under the robot's centre in a step, 0 to 255; 0 beyond the map.
  virtual void costs(const Tile& tile, std::size_t step, double* found) = 0;
  /// The clearances in a step [m]: how far every point of the robot may move, in any direction, without touching an
  /// obstacle. Lower bounds, at most two cells; 0 where the outline touches an obstacle.
  virtual void clearances(const Tile& tile, std::size_t step, double* found) = 0;

 protected:
  Surroundings() = default;
  Surroundings(const Surroundings&) = default;
  Surroundings& operator=(const Surroundings&) = default;
};

}  // namespace hidwa_local_planner
