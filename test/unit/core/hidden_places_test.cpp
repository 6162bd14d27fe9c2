// SPDX-License-Identifier: BSD-3-Clause
#include "core/movers/hidden_places.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/naive_hidden.hpp"
#include "support/random.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner {
namespace {

using test::NaiveHidden;
using test::Random;
using test::Scene;

// Of most scenes here. 2 pi * 2.5 / 0.05 = 314.2: 315 bins.
constexpr double kReach = 2.5;
constexpr double kBin = 2.0 * M_PI / 359.0;  // 2 pi (2.5 + 0.35) / 0.05 = 358.1; 0.0175 [rad]

SensorSector sensor(double x, double y, double direction, double width, double range = 10.0) {
  return {{x, y, M_PI / 180.0 * direction}, M_PI / 180.0 * width, range};
}
const SensorSectors kAllRound{sensor(0.0, 0.0, 0.0, 360.0)};

std::vector<Point> places(const Scene& scene, const SensorSectors& sectors = kAllRound, double reach = kReach) {
  HiddenPlaces hidden;
  hidden.find(scene.grid(), scene.situation.pose, sectors, reach);
  return hidden.all();
}

// Cells are centred on multiples of 0.05 m, from -3 to 3 m. The robot is at the origin.
Scene room() { return Scene::empty(121); }

// A wall along x = 1, one cell thick, up to y = 0.
Scene wall_that_ends() {
  Scene scene = room();
  scene.fill(0.98, -3.1, 1.02, 0.02);
  return scene;
}

// Likewise without an end, but for an opening of so many cells around y = 0.
Scene wall_with_opening(int cells) {
  Scene scene = room();
  scene.fill(0.98, -3.1, 1.02, 3.1);
  scene.fill(0.98, -0.025 * cells, 1.02, 0.025 * cells, cost::kFree);
  return scene;
}

TEST(HiddenPlaces, AreNoneInAnEmptyMapAndWithoutSensors) {
  EXPECT_TRUE(places(room()).empty());
  EXPECT_TRUE(places(wall_that_ends(), {}).empty());
}

TEST(HiddenPlaces, AreNoneBehindAWallThatGoesOnBeyondTheReach) {
  Scene scene = room();
  scene.fill(0.98, -3.1, 1.02, 3.1);  // its ends are hypot(1, 3) = 3.16 m away
  EXPECT_TRUE(places(scene).empty());
}

TEST(HiddenPlaces, LieBesideTheLineOfSightBehindTheEndOfAWall) {
  const std::vector<Point> found = places(wall_that_ends());
  // The last cell's disc reaches up to asin(0.035 / 1) = 0.0354, into bin 2: the line is at 3 bins, 0.0525. Along it,
  // up to 1.1 m away, the cell is nearer than 0.15 m: hypot(0.1, 0.058) = 0.116. At 1.15 m it is hypot(0.15, 0.06) =
  // 0.162. The next ones are 0.3 m apart: 1.15, 1.45, 1.75, 2.05 and 2.35 m.
  ASSERT_EQ(found.size(), 5U);
  const Point ahead(std::cos(3.0 * kBin), std::sin(3.0 * kBin)), left(-ahead.y(), ahead.x());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].dot(ahead), 1.15 + 0.3 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(found[i].dot(left), -0.2, 1e-9);
  }
}

TEST(HiddenPlaces, LieOnBothSidesBehindADoorway) {
  const std::vector<Point> found = places(wall_with_opening(17));  // from -0.4 to 0.4
  std::size_t left = 0;
  for (const Point& place : found) {
    left += place.y() > 0.0;
    EXPECT_GT(place.x(), 1.1);  // in the room
    const bool mirrored = std::any_of(found.begin(), found.end(), [&](const Point& other) {
      return (other - Point(place.x(), -place.y())).norm() < 1e-9;
    });
    EXPECT_TRUE(mirrored) << place.transpose();
  }
  EXPECT_GT(left, 0U);
  EXPECT_EQ(2 * left, found.size());
}

// Nobody comes through 5 or 15 cm.
TEST(HiddenPlaces, AreNoneBehindASlit) {
  for (const int cells : {1, 3}) EXPECT_TRUE(places(wall_with_opening(cells)).empty()) << cells;
}

// From 1 m away one cell's disc hides 2 asin(0.035 / 1) = 0.071, up to 4 bins: 0.080; two hide 0.121, up to 8: 0.160 at
// most. A place and 0.15 m more need 0.35 m beside the line: 0.35 / 0.160 = 2.2 m away, so that the two are looked at
// no farther away than 2 m.
TEST(HiddenPlaces, AreNoneBehindATableLeg) {
  Scene scene = room();
  scene.fill(0.98, -0.02, 1.02, 0.02);
  EXPECT_TRUE(places(scene).empty());
  scene.fill(0.98, -0.02, 1.02, 0.07);
  EXPECT_TRUE(places(scene, kAllRound, 2.0).empty());
}

TEST(HiddenPlaces, LieBehindBothEdgesOfABoxAndNotInIt) {
  Scene scene = room();
  scene.fill(0.98, -0.52, 2.02, 0.52);
  std::size_t left = 0, right = 0;
  for (const Point& place : places(scene)) {
    const bool in = place.x() > 0.83 && place.x() < 2.17 && std::abs(place.y()) < 0.65;  // or nearer than 0.15 m
    EXPECT_FALSE(in) << place.transpose();
    // The line from the sensor along the front's corner at (1, 0.5), and one cell and bin beside it.
    EXPECT_LT(std::abs(place.y()), 0.62 * place.x());
    ++(place.y() > 0.0 ? left : right);
  }
  EXPECT_GT(left, 0U);
  EXPECT_GT(right, 0U);
}

// From (0, 1.5) and (0, -1.5) only the triangle behind the box, from (2, 0.5) and (2, -0.5) to (3, 0), is not seen.
TEST(HiddenPlaces, AreFewerWhereTwoSensorsLookFromBothSides) {
  Scene scene = room();
  scene.fill(0.98, -0.52, 2.02, 0.52);
  const SensorSector left = sensor(0.0, 1.5, 0.0, 360.0), right = sensor(0.0, -1.5, 0.0, 360.0);
  const std::vector<Point> one = places(scene, {left}), both = places(scene, {left, right});
  EXPECT_GT(both.size(), 0U);
  EXPECT_LT(both.size(), one.size());
  for (const Point& place : both) {
    EXPECT_GT(place.x(), 2.1);
    // Cells and bins hide up to 0.035 + 2 * 0.05 m more, across lines with a slope of 1 / 2.
    EXPECT_LT(std::abs(place.y()), 1.5 - 0.5 * place.x() + 0.15);
  }
}

TEST(HiddenPlaces, AreNoneWhereTheSensorDoesNotLook) {
  Scene scene = room();
  scene.fill(-2.02, -0.52, -0.98, 0.52);
  EXPECT_FALSE(places(scene).empty());
  EXPECT_TRUE(places(scene, {sensor(0.0, 0.0, 0.0, 180.0)}).empty());
  EXPECT_FALSE(places(scene, {sensor(0.0, 0.0, 180.0, 180.0)}).empty());
  scene.situation.pose.theta = M_PI;
  EXPECT_FALSE(places(scene, {sensor(0.0, 0.0, 0.0, 180.0)}).empty());
  EXPECT_TRUE(places(scene, {sensor(0.0, 0.0, 180.0, 180.0)}).empty());
}

TEST(HiddenPlaces, MayBeUnknownButNotLethal) {
  const std::vector<Point> in_the_open = places(wall_that_ends());
  Scene scene = wall_that_ends();
  scene.fill(1.03, -3.1, 3.1, 3.1, cost::kUnknown);
  EXPECT_EQ(places(scene), in_the_open);
  scene.fill(1.03, -3.1, 3.1, 3.1, cost::kInscribed);  // only the robot's centre cannot be there
  EXPECT_EQ(places(scene), in_the_open);
  // The places are 0.2 m below the line that rises by 0.04: from y = -0.15 to -0.10. Up to y = -0.05, with 0.05 m
  // between cells, each is nearer than 0.15 m to one.
  scene = wall_that_ends();
  scene.fill(1.03, -3.1, 3.1, -0.03);
  EXPECT_TRUE(places(scene).empty());
}

TEST(HiddenPlaces, AreNoneAlongAWallThatIsVeryNear) {
  for (int k = -10; k <= 10; ++k) {
    Scene scene = room();
    scene.fill(-3.1, 0.28, 3.1, 0.32);
    scene.situation.pose = {0.013 * k, 0.003 * k, 0.3 * k};  // 0.27 to 0.33 m from the wall
    EXPECT_TRUE(places(scene).empty()) << k;
    EXPECT_TRUE(places(scene, {sensor(0.2, 0.0, 0.0, 270.0)}, 2.0).empty()) << k;
  }
}

TEST(HiddenPlaces, AreNoFartherAwayThanTheReach) {
  const Scene scene = wall_that_ends();
  EXPECT_TRUE(places(scene, kAllRound, 0.95).empty());  // the wall is 1 m away
  EXPECT_TRUE(places(scene, {sensor(0.0, 0.0, 0.0, 360.0, 0.95)}).empty());
  std::size_t before = 0;
  for (const double reach : {1.45, 1.75, 2.05, 2.45}) {  // 1, 2, 3, 5 with lines from about 1.2 m on, see above
    const std::vector<Point> found = places(scene, kAllRound, reach);
    EXPECT_GT(found.size(), before) << reach;
    before = found.size();
    // The line's point is in reach, the place 0.2 m beside it.
    for (const Point& place : found) EXPECT_LT(place.norm(), std::hypot(reach, 0.2));
  }
}

// The sight ends where the reach does: what is just beyond it is not hidden for that.
TEST(HiddenPlaces, AreNoneBehindATableLegWhereTheReachEnds) {
  Scene scene = room();
  scene.fill(0.98, -0.02, 1.02, 0.02);
  // The line's point 2.0 m away is in reach, a place 0.2 m beside it is hypot(2.0, 0.2) = 2.010 m away.
  EXPECT_TRUE(places(scene, kAllRound, 2.005).empty());
}

// Walls, boxes and single cells, some of them unknown.
Scene random_room(Random& random) {
  Scene scene = Scene::empty(101, random.pick({0.05, 0.04, 0.1}));
  const double half = 0.5 * 101 * scene.resolution;
  scene.situation.pose.x = random.uniform(-0.5, 0.5);
  scene.situation.pose.y = random.uniform(-0.5, 0.5);
  scene.situation.pose.theta = random.uniform(-M_PI, M_PI);
  for (int k = random.integer(1, 8); k > 0; --k) {
    const double x = random.uniform(-half, half), y = random.uniform(-half, half);
    double wide = scene.resolution, high = scene.resolution;
    const double kind = random.uniform(0.0, 1.0);
    if (kind < 0.4) {
      (random.chance(0.5) ? wide : high) = random.uniform(0.5, 3.0);
    } else if (kind < 0.8) {
      wide = random.uniform(0.1, 1.0);
      high = random.uniform(0.1, 1.0);
    }
    scene.fill(x, y, x + wide, y + high, random.chance(0.1) ? cost::kUnknown : cost::kLethal);
  }
  return scene;
}

SensorSectors random_sensors(Random& random) {
  SensorSectors sectors;
  for (int k = random.integer(1, 2); k > 0; --k) {
    SensorSector one;
    one.pose.x = random.uniform(-0.3, 0.3);
    one.pose.y = random.uniform(-0.3, 0.3);
    one.pose.theta = random.uniform(-M_PI, M_PI);
    one.width = random.chance(0.3) ? 2.0 * M_PI : random.uniform(1.0, 6.0);
    one.range = random.chance(0.7) ? 10.0 : random.uniform(0.5, 3.0);
    sectors.push_back(one);
  }
  return sectors;
}

TEST(HiddenPlaces, AreThoseOfASlowTwinAndBehindSomething) {
  Random random(4851);
  int some = 0;
  std::size_t count = 0;
  HiddenPlaces hidden;
  for (int k = 0; k < 300; ++k) {
    const Scene scene = random_room(random);
    const SensorSectors sectors = random_sensors(random);
    const double reach = random.uniform(0.3, 4.0);
    hidden.find(scene.grid(), scene.situation.pose, sectors, reach);
    const NaiveHidden twin(scene.grid(), scene.situation.pose, sectors, reach);
    const std::vector<Point> expected = twin.places();
    ASSERT_EQ(hidden.all().size(), expected.size()) << k;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_LT((hidden.all()[i] - expected[i]).norm(), 1e-9) << k << ": " << i;
      EXPECT_TRUE(twin.is_behind_something(hidden.all()[i])) << k << ": " << i;
    }
    some += !expected.empty();
    count += expected.size();
  }
  EXPECT_GT(some, 100);
  EXPECT_GT(count, 500U);
}

}  // namespace
}  // namespace hidwa_local_planner
