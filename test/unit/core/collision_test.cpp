// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/collision.hpp"

#include <cmath>

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
  EXPECT_FALSE(overlaps_square(square, 1.1, 0.2, 0.5));
}

TEST(OverlapsSquare, AnEdgeThatCutsACornerOff) {
  // x + y = 1.9 passes the cell [0.9, 1.4]^2 at its corner (0.9, 0.9): 1.8 < 1.9.
  const Polygon triangle{{0.0, 0.0}, {1.9, 0.0}, {0.0, 1.9}};
  EXPECT_TRUE(overlaps_square(triangle, 0.9, 0.9, 0.5));
  EXPECT_FALSE(overlaps_square(triangle, 0.96, 0.96, 0.5));  // 1.92 > 1.9
}

TEST(OverlapsSquare, ADentIsFree) {
  const Polygon u{{0.0, 0.0}, {3.0, 0.0}, {3.0, 3.0}, {2.0, 3.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 3.0}, {0.0, 3.0}};
  EXPECT_FALSE(overlaps_square(u, 1.25, 1.5, 0.5));
  EXPECT_TRUE(overlaps_square(u, 1.25, 0.75, 0.5));
}

CollisionChecker prepared(const Scene& scene, const Footprint& footprint, bool unknown = true) {
  CollisionChecker checker;
  checker.prepare(scene.grid(), footprint, unknown, {}, 1.0, scene.resolution);
  return checker;
}

// Cells of 0.05 m, the origin at the middle of cell (30, 30): cell (i, j) spans (i - 30.5) * 0.05 on.
TEST(Collision, ARectangleBesideACell) {
  Scene scene = Scene::empty(61);
  scene.at({40, 30}) = cost::kLethal;  // x from 0.475 to 0.525
  const Footprint footprint(Polygon{{0.2, 0.1}, {-0.2, 0.1}, {-0.2, -0.1}, {0.2, -0.1}});
  const CollisionChecker checker = prepared(scene, footprint);
  EXPECT_FALSE(checker.collides({0.2749, 0.0, 0.0}));  // front at 0.4749
  EXPECT_TRUE(checker.collides({0.2751, 0.0, 0.0}));
  EXPECT_FALSE(checker.collides({0.37, 0.0, M_PI / 2}));  // front at 0.37 + 0.1
  EXPECT_TRUE(checker.collides({0.38, 0.0, M_PI / 2}));
}

TEST(Collision, ADiscIsExactAndMindsInscribedCells) {
  Scene scene = Scene::empty(61);
  scene.at({40, 30}) = cost::kLethal;
  const Footprint disc({}, 0.2);
  const CollisionChecker checker = prepared(scene, disc);
  EXPECT_FALSE(checker.collides({0.2749, 0.0, 0.0}));
  EXPECT_TRUE(checker.collides({0.2751, 0.0, 0.0}));
  // Past the corner (0.475, 0.025): at (0.475 - 0.15, 0.025 + 0.14) it is hypot(0.15, 0.14) = 0.2052 away.
  EXPECT_FALSE(checker.collides({0.325, 0.165, 0.0}));
  EXPECT_TRUE(checker.collides({0.335, 0.165, 0.0}));  // hypot(0.14, 0.14) = 0.198
  scene.at({20, 20}) = cost::kInscribed;               // the middle of it is (-0.5, -0.5)
  EXPECT_TRUE(prepared(scene, disc).collides({-0.5, -0.5, 0.0}));
  const Footprint square(Polygon{{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}});
  EXPECT_FALSE(prepared(scene, square).collides({-0.5, -0.5, 0.0}));  // a polygon is tested itself
}

TEST(Collision, UnknownByPolicyAndTheEdgeAlways) {
  Scene scene = Scene::empty(61);
  scene.at({40, 30}) = cost::kUnknown;
  const Footprint footprint(Polygon{{0.2, 0.1}, {-0.2, 0.1}, {-0.2, -0.1}, {0.2, -0.1}});
  EXPECT_TRUE(prepared(scene, footprint, true).collides({0.4, 0.0, 0.0}));
  EXPECT_FALSE(prepared(scene, footprint, false).collides({0.4, 0.0, 0.0}));
  // The map ends at 61 * 0.05 / 2 = 1.525.
  EXPECT_FALSE(prepared(scene, footprint).collides({1.32, 0.0, 0.0}));
  EXPECT_TRUE(prepared(scene, footprint).collides({1.33, 0.0, 0.0}));
}

TEST(Collision, FarBeyondThePreparedReachItStillAnswers) {
  Scene scene = Scene::empty(61);
  scene.at({55, 30}) = cost::kLethal;  // x from 1.225 on
  const Footprint footprint(Polygon{{0.2, 0.1}, {-0.2, 0.1}, {-0.2, -0.1}, {0.2, -0.1}});
  CollisionChecker checker;
  checker.prepare(scene.grid(), footprint, true, {-1.0, 0.0, 0.0}, 0.1, scene.resolution);
  EXPECT_TRUE(checker.collides({1.1, 0.0, 0.0}));
  EXPECT_FALSE(checker.collides({1.0, 0.0, 0.0}));
}

TEST(Collision, APolygonAroundNothingOfTheOrigin) {
  // The body lies 0.3 to 0.5 m ahead of the origin: an obstacle under the origin itself does not matter.
  Scene scene = Scene::empty(61);
  scene.at({30, 30}) = cost::kLethal;
  const Footprint footprint(Polygon{{0.5, 0.1}, {0.3, 0.1}, {0.3, -0.1}, {0.5, -0.1}});
  EXPECT_FALSE(prepared(scene, footprint).collides({0.0, 0.0, 0.0}));
  EXPECT_TRUE(prepared(scene, footprint).collides({-0.4, 0.0, 0.0}));
}

double separation(const CollisionChecker& checker, const Pose2& pose, double cap) {
  return checker.clearance(pose, {std::cos(pose.theta), std::sin(pose.theta)}, cap);
}

TEST(Separation, UpToTheRoomThatWasAskedFor) {
  Scene scene = Scene::empty(61);
  scene.at({50, 30}) = cost::kLethal;  // x from 0.975 on
  const Footprint footprint(Polygon{{0.2, 0.1}, {-0.2, 0.1}, {-0.2, -0.1}, {0.2, -0.1}});
  CollisionChecker checker;
  checker.prepare(scene.grid(), footprint, true, {}, 1.0, 0.05, 0.42);
  EXPECT_NEAR(checker.largest_clearance(), 0.45, 1e-9);                 // by whole cells
  EXPECT_NEAR(separation(checker, {0.575, 0.0, 0.0}, 1.0), 0.2, 1e-8);  // 0.975 - 0.775
  EXPECT_NEAR(separation(checker, {0.575, 0.0, 0.0}, 0.15), 0.15, 1e-8);
  EXPECT_NEAR(separation(checker, {0.0, 0.0, 0.0}, 1.0), 0.45, 1e-8);
  EXPECT_EQ(separation(checker, {0.8, 0.0, 0.0}, 1.0), 0.0);
  EXPECT_NEAR(prepared(scene, footprint).largest_clearance(), 0.1, 1e-9);  // two cells at least
}

TEST(Separation, OfAnOutlineWithADentItIsTheDistance) {
  Scene scene = Scene::empty(61);
  scene.at({30, 34}) = cost::kLethal;  // x from -0.025 to 0.025, y from 0.175 to 0.225
  // A fork: two prongs from y = 0.1 up to 0.3, 0.2 m apart. The cell lies between them.
  const Footprint fork(
      Polygon{{0.2, -0.1}, {0.2, 0.3}, {0.1, 0.3}, {0.1, 0.1}, {-0.1, 0.1}, {-0.1, 0.3}, {-0.2, 0.3}, {-0.2, -0.1}});
  CollisionChecker checker;
  checker.prepare(scene.grid(), fork, true, {}, 1.0, 0.05, 0.4);
  EXPECT_NEAR(separation(checker, {0.0, 0.0, 0.0}, 0.4), 0.075,
              1e-8);  // 0.1 - 0.025 to either prong, 0.175 - 0.1 below
  EXPECT_NEAR(separation(checker, {0.03, 0.0, 0.0}, 0.4), 0.045, 1e-8);
  EXPECT_NEAR(separation(checker, {0.0, 0.05, 0.0}, 0.4), 0.025, 1e-8);
}

}  // namespace
}  // namespace hidwa_local_planner
