// SPDX-License-Identifier: BSD-3-Clause
// The check of rollouts, which skips what it can, against the outline at every pose by itself.
#include "core/collision/rollout_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "core/collision/admissibility.hpp"
#include "core/collision/cell_classes.hpp"
#include "support/random_scene.hpp"
#include "support/scene_rollout.hpp"

namespace hidwa_local_planner {
namespace {

using test::Scene;

// The candidates of a scene, and their check.
struct CheckedCycle : test::SceneRollout {
  explicit CheckedCycle(const Scene& scene)
      : SceneRollout(scene), pending(PendingMotion(scene.situation.last_command, scene.parameters.control_latency)) {
    const Situation& s = scene.situation;
    const bool unknown = scene.parameters.unknown_is_obstacle;
    checker.prepare(grid, footprint, unknown, s.pose, reach, grid.resolution, 2.0 * grid.resolution);
    start.pending = &pending;
    check.prepare(scene.parameters, checker, footprint, grid.resolution, {&start});
  }
  PendingMotionSet pending;
  CollisionChecker checker;
  CellClasses classes;
  AdmissibilityCheck check;
};

// Of the places between two poses of a rollout, `parts` of them, the least clearance [m], up to a cell.
double least_between(const CheckedCycle& cycle, const Tile& tile, std::size_t c, std::size_t k, int parts) {
  const Pose2 a = tile.pose(k - 1, c), b = tile.pose(k, c);
  double least = cycle.grid.resolution;
  for (int part = 0; part <= parts; ++part) {
    const double t = static_cast<double>(part) / parts;
    const Pose2 pose{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.theta + t * (b.theta - a.theta)};
    least = std::min(least, cycle.checker.clearance(pose, Rotation::of(pose.theta), cycle.grid.resolution));
  }
  return least;
}

// A pose that collides rejects its rollout. A rollout that is rejected comes nearer than an eighth of a cell to
// something: so much a clearance that is remembered may be too small.
TEST(RolloutCheck, AsEveryPoseByItself) {
  int free = 0, rejected = 0, by_a_pose = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const Scene scene = test::random_scene(seed);
    CheckedCycle cycle(scene);
    if (cycle.checker.collides(scene.situation.pose)) continue;
    for (std::size_t t = 0; t < cycle.rollout.tile_count(); ++t) {
      Tile tile = cycle.rollout.tile(t);
      tile.cells = cycle.classes.under(cycle.checker, tile);
      std::vector<const char*> reasons(tile.count, nullptr);
      cycle.check.check_rollouts(tile, reasons.data());
      for (std::size_t c = 0; c < tile.count; ++c) {
        bool collides = false;
        for (std::size_t k = 1; k <= tile.steps && !collides; ++k) collides = cycle.checker.collides(tile.pose(k, c));
        by_a_pose += collides;
        if (collides) {
          ASSERT_NE(reasons[c], nullptr) << "seed " << seed << ", tile " << t << ", candidate " << c;
        }
        ++(reasons[c] == nullptr ? free : rejected);
        if (reasons[c] == nullptr || collides) continue;
        double least = cycle.grid.resolution;
        for (std::size_t k = 1; k <= tile.steps; ++k) least = std::min(least, least_between(cycle, tile, c, k, 32));
        ASSERT_LT(least, cycle.grid.resolution / 8.0) << "seed " << seed << ", tile " << t << ", candidate " << c;
      }
    }
  }
  std::printf("%d free, %d rejected, %d of them by a pose\n", free, rejected, by_a_pose);
  for (const int often : {free, rejected, by_a_pose}) EXPECT_GT(often, 1000);
  EXPECT_GT(rejected, by_a_pose);  // some by what lies between
}

}  // namespace
}  // namespace hidwa_local_planner
