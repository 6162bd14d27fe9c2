// SPDX-License-Identifier: BSD-3-Clause
// By hand; test/oracle/collision_twin_test.cpp compares random outlines, obstacles and poses.
#include "core/collision/collision.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::Scene;

TEST(OverlapsSquare, SharedAreaCountsTouchingDoesNot) {
  const Polygon square{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  EXPECT_TRUE(overlaps_square(square, 0.9, 0.9, 0.5));    // a corner reaches in
  EXPECT_FALSE(overlaps_square(square, 1.0, 0.0, 0.5));   // along an edge
  EXPECT_FALSE(overlaps_square(square, 1.0, 1.0, 0.5));   // at a corner
  EXPECT_TRUE(overlaps_square(square, 0.25, 0.25, 0.5));  // the cell lies inside
  EXPECT_TRUE(overlaps_square(square, -1.0, -1.0, 3.0));  // the polygon lies inside
}

// Cells of 0.05 m, the origin at the middle of cell (30, 30): cell (i, j) spans (i - 30.5) * 0.05 on.
const Polygon kRectangle{{0.2, 0.1}, {-0.2, 0.1}, {-0.2, -0.1}, {0.2, -0.1}};

CollisionChecker prepared(const Scene& scene, const Footprint& footprint, double room = 0.0) {
  CollisionChecker checker;
  checker.prepare(scene.grid(), footprint, true, {}, 1.0, scene.resolution, room);
  return checker;
}

// The body lies 0.3 to 0.5 m ahead of the origin: an obstacle under the origin itself does not matter.
TEST(Collision, APolygonAroundNothingOfTheOrigin) {
  Scene scene = Scene::empty(61);
  scene.at({30, 30}) = cost::kLethal;
  const Footprint footprint(Polygon{{0.5, 0.1}, {0.3, 0.1}, {0.3, -0.1}, {0.5, -0.1}});
  EXPECT_FALSE(prepared(scene, footprint).collides({0.0, 0.0, 0.0}));
  EXPECT_TRUE(prepared(scene, footprint).collides({-0.4, 0.0, 0.0}));
}

TEST(Separation, UpToTheRoomThatWasAskedFor) {
  Scene scene = Scene::empty(61);
  scene.at({50, 30}) = cost::kLethal;  // x from 0.975 on
  const Footprint footprint(kRectangle);
  const CollisionChecker checker = prepared(scene, footprint, 0.42);
  EXPECT_NEAR(checker.largest_clearance(), 0.45, 1e-9);  // by whole cells
  const Rotation ahead;
  EXPECT_NEAR(checker.clearance({0.575, 0.0, 0.0}, ahead, 1.0), 0.2, 1e-8);  // 0.975 - 0.775
  EXPECT_NEAR(checker.clearance({0.575, 0.0, 0.0}, ahead, 0.15), 0.15, 1e-8);
  EXPECT_NEAR(checker.clearance({0.0, 0.0, 0.0}, ahead, 1.0), 0.45, 1e-8);
  EXPECT_EQ(checker.clearance({0.8, 0.0, 0.0}, ahead, 1.0), 0.0);
  EXPECT_NEAR(prepared(scene, footprint).largest_clearance(), 0.1, 1e-9);  // two cells at least
}

}  // namespace
}  // namespace hidwa_local_planner
