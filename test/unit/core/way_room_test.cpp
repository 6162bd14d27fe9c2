// SPDX-License-Identifier: BSD-3-Clause
// The room on a way is that of its narrowest station within three seconds, on the map of now.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/collision/collision.hpp"
#include "core/search/way.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::Scene;

constexpr double kCell = 0.05;
const Polygon kSquare = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};

// Along the x axis. Left: 4 s at x = -0.9, 2.5 s at -0.3, 1.2 s at 0.3, nothing at 0.9.
Way straight_way() {
  Way way;
  way.add({{-0.9, 0.0, 0.0}, 4.0});
  way.add({{-0.3, 0.0, 0.0}, 2.5});
  way.add({{0.3, 0.0, 0.0}, 1.2});
  way.add({{0.9, 0.0, 0.0}, 0.0});
  return way;
}

// How far the lower edges of the lethal cells are above the square's upper side, which lies at y = 0.2.
double gap_above(const Scene& scene) {
  const GridView grid = scene.grid();
  double lowest = INFINITY;
  for (int j = 0; j < grid.size_y; ++j) {
    for (int i = 0; i < grid.size_x; ++i) {
      if (grid.at({i, j}) == cost::kLethal) lowest = std::min(lowest, grid.centre({i, j}).y() - 0.5 * kCell);
    }
  }
  return lowest - 0.2;
}

double room_of(const Scene& scene, std::size_t part) {
  const Footprint square(kSquare);
  CollisionChecker collision;
  collision.prepare(scene.grid(), square, true, {}, 2.0, 0.01, kCell);
  return straight_way().room_ahead(part, collision, kCell);
}

TEST(WayRoom, IsACellWhereNothingIsNear) { EXPECT_EQ(room_of(Scene::empty(81, kCell), 0), kCell); }

TEST(WayRoom, IsThatOfTheNarrowestStationWithinThreeSeconds) {
  Scene scene = Scene::empty(81, kCell);
  scene.fill(0.8, 0.23, 1.0, 0.4);  // beside the last station alone: 1.2 s after the third, 2.5 s after the second
  const double gap = gap_above(scene);
  ASSERT_GT(gap, 0.0);
  ASSERT_LT(gap, kCell);
  EXPECT_EQ(room_of(scene, 0), kCell);  // it comes 4 s later
  EXPECT_NEAR(room_of(scene, 1), gap, 1e-6);
  EXPECT_NEAR(room_of(scene, 2), gap, 1e-6);
}

TEST(WayRoom, IsNothingWhereAStationIsBlocked) {
  Scene scene = Scene::empty(81, kCell);
  scene.fill(0.2, -0.05, 0.4, 0.05);
  EXPECT_EQ(room_of(scene, 0), 0.0);
  EXPECT_EQ(room_of(scene, 2), kCell);  // it lies behind
}

TEST(WayRoom, OfAWayThatIsOverIsACell) { EXPECT_EQ(room_of(Scene::empty(81, kCell), 3), kCell); }

}  // namespace
}  // namespace hidwa_local_planner
