// SPDX-License-Identifier: BSD-3-Clause
#include "core/movers/hidden_places.hpp"

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

// A wall with an opening around y = 0; `cells` is its width. The ends of the wall are hypot(1, 3) = 3.16 m away.
Scene wall_with_opening(int cells) {
  Scene scene = room();
  scene.fill(0.98, -3.1, 1.02, 3.1);
  scene.fill(0.98, -0.025 * cells, 1.02, 0.025 * cells, cost::kFree);
  return scene;
}

// The leg of a table 1 m ahead; `cells` is its width.
Scene table_leg(int cells) {
  Scene scene = room();
  scene.fill(0.98, -0.02, 1.02, 0.05 * cells - 0.03);
  return scene;
}

struct Nobody {
  const char* where;
  Scene scene;
  SensorSectors sectors = kAllRound;
  double reach = kReach;  // [m]
};

TEST(HiddenPlaces, AreNoneWhereNobodyFitsOrNothingHides) {
  for (const Nobody& nobody : {
           Nobody{"in an empty map", room()},
           Nobody{"without sensors", wall_that_ends(), {}},
           Nobody{"behind a wall that goes on beyond the reach", wall_with_opening(0)},
           Nobody{"behind a slit of 5 cm, through which nobody comes", wall_with_opening(1)},
           Nobody{"behind a slit of 15 cm", wall_with_opening(3)},
           // From 1 m away one cell's disc hides 2 asin(0.035 / 1) = 0.071, up to 4 bins: 0.080; two hide 0.121, up to
           // 8: 0.160 at most. A place and 0.15 m more need 0.35 m beside the line: 0.35 / 0.160 = 2.2 m away.
           Nobody{"behind the leg of a table", table_leg(1)},
           Nobody{"behind a wide leg of a table, up to 2 m away", table_leg(2), kAllRound, 2.0},
           // The sight ends where the reach does: what is just beyond it is not hidden for that. The line's point 2.0 m
           // away is in reach, a place 0.2 m beside it is hypot(2.0, 0.2) = 2.010 m away.
           Nobody{"behind the leg of a table where the reach ends", table_leg(1), kAllRound, 2.005},
           Nobody{"behind a wall that is out of reach", wall_that_ends(), kAllRound, 0.95},
           Nobody{"behind a wall that is out of sight", wall_that_ends(), {sensor(0.0, 0.0, 0.0, 360.0, 0.95)}},
       }) {
    EXPECT_TRUE(places(nobody.scene, nobody.sectors, nobody.reach).empty()) << nobody.where;
  }
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
