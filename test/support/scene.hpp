// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/planner.hpp"

namespace hidwa_local_planner::test {

/// Somebody at a place who keeps his velocity.
inline MovingObstacleEstimate mover_at(double x, double y, double vx = 0.0, double vy = 0.0) {
  MovingObstacleEstimate mover;
  mover.id = 1;
  mover.position = {x, y};
  mover.velocity = {vx, vy};
  mover.radius = 0.3;
  return mover;
}

/// Everything that one cycle depends on, with the map's memory.
struct Scene {
  Parameters parameters;
  Polygon outline;  // robot frame [m]
  int size_x = 0, size_y = 0;
  double resolution = 0.05, origin_x = 0.0, origin_y = 0.0;  // [m]
  std::vector<std::uint8_t> costs;
  Situation situation;
  OperatorIntent intent;

  /// The sampling that expectations count on: few candidates, and round figures.
  static Parameters few_samples() {
    Parameters p;
    p.sim_time = 1.7;
    p.PathAlign_scale = p.PathDist_scale = 32.0;
    p.vx_samples = p.vth_samples = 20;
    p.trans_stopped_velocity = p.rot_stopped_velocity = 0.1;
    return p;
  }

  /// An empty map of `cells` x `cells` around the origin, a robot at `pose` with a straight plan along +x.
  static Scene empty(int cells = 61, double resolution = 0.05) {
    Scene scene;
    scene.parameters = few_samples();
    scene.size_x = scene.size_y = cells;
    scene.resolution = resolution;
    scene.origin_x = scene.origin_y = -0.5 * cells * resolution;
    scene.costs.assign(static_cast<std::size_t>(cells * cells), cost::kFree);
    scene.outline = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};
    for (int i = -20; i <= 20; ++i) scene.situation.plan.push_back({0.05 * i, 0.0, 0.0});
    scene.situation.goal = {8.0, 0.0, 0.0};
    return scene;
  }

  GridView grid() const { return {costs.data(), size_x, size_y, resolution, origin_x, origin_y}; }
  std::uint8_t& at(Cell cell) { return costs[grid().index(cell)]; }
  void steer(const Twist2& u_h) {
    intent.state = OperatorStateId::shared;
    intent.influence = Influence::shared;
    intent.u_h = u_h;
  }
  /// Sets every cell whose centre lies in the rectangle.
  void fill(double x0, double y0, double x1, double y1, std::uint8_t value = cost::kLethal) {
    for (int j = 0; j < size_y; ++j) {
      for (int i = 0; i < size_x; ++i) {
        const Point c = grid().centre({i, j});
        if (c.x() > x0 && c.x() < x1 && c.y() > y0 && c.y() < y1) at({i, j}) = value;
      }
    }
  }
};

}  // namespace hidwa_local_planner::test
