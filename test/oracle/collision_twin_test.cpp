// SPDX-License-Identifier: BSD-3-Clause
// The collision check against areas and nearest points: random outlines, random obstacles, random poses.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "core/collision/collision.hpp"
#include "core/collision/outline_depth.hpp"
#include "support/naive_escape.hpp"
#include "support/naive_planner.hpp"
#include "support/random_scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::NaiveBody;
using test::Random;
using test::Scene;

// Overlaps below it are doubtful [m, or the root of m^2].
constexpr double kDoubt = 1e-6;

struct Tally {
  int poses = 0, hits = 0, doubtful = 0, between = 0;
};

void compare_pose(const Scene& scene, const CollisionChecker& checker, const NaiveBody& body, const Pose2& pose,
                  Tally& tally) {
  const GridView grid = scene.grid();
  const double overlap = test::naive_overlap(grid, body, pose, scene.parameters.unknown_is_obstacle);
  ++tally.poses;
  if (overlap > 0.0 && overlap < kDoubt) {
    ++tally.doubtful;
    return;
  }
  const bool hit = overlap > 0.0 || test::naive_centre_inscribed(grid, body, pose);
  tally.hits += hit;
  ASSERT_EQ(checker.collides(pose), hit) << pose.x << " " << pose.y << " " << pose.theta << " overlap " << overlap;
  // Within one cell's side of a clear place nothing collides, at any heading.
  if (checker.clear(pose.x, pose.y)) {
    for (int k = 0; k < 8; ++k) {
      const double angle = M_PI / 4 * k;
      const Pose2 near{pose.x + 0.99 * scene.resolution * std::cos(angle),
                       pose.y + 0.99 * scene.resolution * std::sin(angle), angle};
      ASSERT_LT(test::naive_overlap(grid, body, near, scene.parameters.unknown_is_obstacle), kDoubt);
    }
  }
}

void compare_scene(std::uint64_t seed, Tally& tally) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const Scene scene = test::random_scene(seed);
  const NaiveBody body = test::naive_body(scene);
  const Footprint footprint = Footprint::from_outline(scene.outline, scene.parameters.footprint_padding);
  CollisionChecker checker;
  const double reach = random.uniform(0.0, 2.0);  // poses beyond it must be right, too
  checker.prepare(scene.grid(), footprint, scene.parameters.unknown_is_obstacle, scene.situation.pose, reach,
                  scene.resolution);
  const double width = scene.size_x * scene.resolution, height = scene.size_y * scene.resolution;
  for (int k = 0; k < 60; ++k) {
    const Pose2 pose{scene.origin_x + random.uniform(-0.5, width + 0.5),
                     scene.origin_y + random.uniform(-0.5, height + 0.5), random.uniform(-4.0, 4.0)};
    compare_pose(scene, checker, body, pose, tally);
    if (testing::Test::HasFatalFailure()) return;
  }
}

// The room around a pose, up to what was asked for when it was prepared.
void compare_room(std::uint64_t seed, Tally& tally) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const Scene scene = test::random_scene(seed);
  const NaiveBody body = test::naive_body(scene);
  const bool unknown = scene.parameters.unknown_is_obstacle;
  const Footprint footprint = Footprint::from_outline(scene.outline, scene.parameters.footprint_padding);
  CollisionChecker checker;
  const double room = random.uniform(0.0, 0.6), reach = 1.0;
  checker.prepare(scene.grid(), footprint, unknown, scene.situation.pose, reach, scene.resolution, room);
  ASSERT_GE(checker.largest_clearance(), room);
  for (int k = 0; k < 40; ++k) {
    const Pose2& start = scene.situation.pose;
    const Pose2 pose{start.x + random.uniform(-0.7, 0.7), start.y + random.uniform(-0.7, 0.7),
                     random.uniform(-4.0, 4.0)};
    const double overlap = test::naive_overlap(scene.grid(), body, pose, unknown);
    const double cap = random.uniform(0.01, 0.6), most = std::min(cap, checker.largest_clearance());
    const double gap = test::naive_gap(scene.grid(), body, pose, unknown, most);
    const double told = checker.clearance(pose, {std::cos(pose.theta), std::sin(pose.theta)}, cap);
    ++tally.poses;
    tally.doubtful += overlap > 0.0 && overlap < kDoubt;
    if (overlap > 0.0 && overlap < kDoubt) continue;
    const bool hit = overlap > 0.0 || test::naive_centre_inscribed(scene.grid(), body, pose);
    tally.hits += hit;
    ASSERT_NEAR(told, hit ? 0.0 : gap, 2e-9) << pose.x << " " << pose.y << " " << pose.theta;
    tally.between += !hit && gap < most;
  }
}

TEST(CollisionTwin, TheRoomAroundAPose) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 400 && !HasFatalFailure(); ++seed) compare_room(3500000 + seed, tally);
  std::printf("%d poses, %d hits, %d near something, %d doubtful\n", tally.poses, tally.hits, tally.between,
              tally.doubtful);
  EXPECT_GT(tally.hits, tally.poses / 20);
  EXPECT_GT(tally.between, tally.poses / 10);
  EXPECT_LT(tally.doubtful, tally.poses / 1000);
}

TEST(CollisionTwin, RandomOutlinesObstaclesAndPoses) {
  Tally tally;
  for (std::uint64_t seed = 0; seed < 500 && !HasFatalFailure(); ++seed) compare_scene(3000000 + seed, tally);
  std::printf("%d poses, %d hits, %d doubtful\n", tally.poses, tally.hits, tally.doubtful);
  EXPECT_GT(tally.hits, tally.poses / 10);
  EXPECT_LT(tally.hits, tally.poses * 9 / 10);
  EXPECT_LT(tally.doubtful, tally.poses / 1000);
}

// How deep random outlines lie in random cells: convex ones, others and discs, against the Minkowski difference.
TEST(DepthTwin, RandomOutlinesAndCells) {
  Random random(7);
  int hits = 0;
  for (int k = 0; k < 20000; ++k) {
    const double side = random.uniform(0.02, 0.2);
    NaiveBody body;
    const int shape = random.integer(0, 2);
    if (shape == 0) body.radius = random.uniform(0.1, 0.3);
    if (shape == 1) body.corners = test::random_convex_outline(random);
    if (shape == 2) body.corners = test::random_star_outline(random);
    const Footprint footprint(body.corners, body.radius);
    const Pose2 pose{random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), random.uniform(-4.0, 4.0)};
    const double x[4] = {}, y[4] = {};
    double depth[4];
    OutlineDepth outline;
    outline.prepare(footprint, side);
    outline.of(pose, {std::cos(pose.theta), std::sin(pose.theta)}, x, y, 1, depth);
    NaiveBody hull = body;  // of an outline that is not convex
    if (!body.corners.empty()) hull.corners = test::naive_hull(body.corners);
    const double overlap = test::naive_overlap_of(body, pose, -0.5 * side, -0.5 * side, side);
    const double expected = overlap > 0.0 ? test::naive_depth(hull, pose, -0.5 * side, -0.5 * side, side) : 0.0;
    if (overlap > 0.0 && overlap < kDoubt) continue;
    hits += expected > 0.0;
    ASSERT_NEAR(std::max(depth[0], 0.0), expected, 1e-9) << k << ", shape " << shape;
  }
  EXPECT_GT(hits, 5000);
  EXPECT_LT(hits, 15000);
}

// overlaps_square alone: polygons about as large as the square, near it.
TEST(OverlapTwin, RandomPolygonsAndSquares) {
  Random random(5);
  int hits = 0, doubtful = 0;
  for (int k = 0; k < 20000; ++k) {
    const Polygon polygon =
        random.chance(0.5) ? test::random_convex_outline(random) : test::random_star_outline(random);
    const double side = random.uniform(0.02, 0.5);
    const double x = random.uniform(-0.6, 0.4), y = random.uniform(-0.6, 0.4);
    const double overlap = std::sqrt(test::naive_shared_area(polygon, x, y, side));
    if (overlap > 0.0 && overlap < kDoubt) {
      ++doubtful;
      continue;
    }
    hits += overlap > 0.0;
    ASSERT_EQ(overlaps_square(polygon, x, y, side), overlap > 0.0) << k << " " << overlap;
  }
  EXPECT_GT(hits, 4000);
  EXPECT_LT(hits, 16000);
  EXPECT_LT(doubtful, 20);
}

}  // namespace
}  // namespace hidwa_local_planner
