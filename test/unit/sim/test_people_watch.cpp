// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/people_watch.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

const Polygon kBox{{0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}};  // [m]

Mover mover(double x, double vx, std::uint32_t id = 1) {
  Mover m;
  m.id = id;
  m.radius = 0.3;
  m.position = {x, 0.0};
  m.velocity = {vx, 0.0};
  return m;
}

TEST(PeopleWatch, ATouchOfTheStandingRobotIsTheOthers) {
  PeopleWatch watch(kBox);
  watch.add(1.0, 0.01, {}, {}, {mover(0.81, -1.0)});  // gap 0.81 - 0.5 - 0.3
  EXPECT_TRUE(watch.touches().empty());
  EXPECT_NEAR(watch.closest(), 0.01, 1e-12);
  watch.add(1.01, 0.01, {}, {}, {mover(0.79, -1.0)});
  ASSERT_EQ(watch.touches_at_rest(), 1);
  EXPECT_EQ(watch.touches_moving(), 0);
  EXPECT_FALSE(watch.touches()[0].by_robot);
  EXPECT_EQ(watch.touches()[0].speed, 1.0);
  EXPECT_EQ(watch.closest(), 0.0);
  EXPECT_EQ(watch.encounters(), 0);  // the robot did not move
  EXPECT_NEAR(watch.standing(), 0.02, 1e-12);
}

TEST(PeopleWatch, WhoComesFasterMovedIntoTheOther) {
  for (const bool robot : {true, false}) {
    PeopleWatch watch(kBox);
    watch.add(1.0, 0.01, {}, {0.5, 0.0}, {mover(0.79, robot ? -0.4 : -0.6)});
    ASSERT_EQ(watch.touches_moving(), 1);
    EXPECT_EQ(watch.touches()[0].by_robot, robot);
  }
  PeopleWatch leaving(kBox);  // at 0.5 m/s, from somebody who comes after it
  leaving.add(1.0, 0.01, {}, {0.5, 0.0}, {mover(-0.79, 0.6)});
  ASSERT_EQ(leaving.touches_moving(), 1);
  EXPECT_FALSE(leaving.touches()[0].by_robot);
}

TEST(PeopleWatch, TurningIsMovingToo) {
  // The outermost point is 0.707 m away: 0.02 rad/s are 14 mm/s, 0.01 rad/s are 7 mm/s.
  PeopleWatch turning(kBox), resting(kBox);
  turning.add(1.0, 0.01, {}, {0.0, 0.02}, {mover(0.7, 0.0)});
  resting.add(1.0, 0.01, {}, {0.0, 0.01}, {mover(0.7, 0.0)});
  EXPECT_EQ(turning.touches_moving(), 1);
  EXPECT_EQ(resting.touches_at_rest(), 1);
}

TEST(PeopleWatch, AnOverlapIsOneTouchUntilItEnds) {
  PeopleWatch watch(kBox);
  for (const double x : {0.85, 0.75, 0.7, 0.85, 0.75}) watch.add(1.0, 0.01, {}, {0.5, 0.0}, {mover(x, 0.0)});
  EXPECT_EQ(watch.touches_moving(), 2);
}

TEST(PeopleWatch, CountsEncountersAndPersonalSpace) {
  PeopleWatch watch(kBox);
  const auto at = [&](double gap, double v) { watch.add(1.0, 0.1, {}, {v, 0.0}, {mover(gap + 0.8, 0.0)}); };
  at(0.9, 0.0);  // near, but the robot stands
  EXPECT_EQ(watch.encounters(), 0);
  at(0.9, 0.5);
  at(0.4, 0.5);
  at(1.2, 0.5);  // not far enough away for a new one
  at(0.9, 0.5);
  EXPECT_EQ(watch.encounters(), 1);
  at(1.6, 0.5);
  at(0.9, 0.5);
  EXPECT_EQ(watch.encounters(), 2);
  EXPECT_NEAR(watch.personal_space(), 0.1, 1e-12);
  EXPECT_NEAR(watch.standing(), 0.1, 1e-12);
  EXPECT_NEAR(watch.closest(), 0.4, 1e-12);
}

TEST(PeopleWatch, KnowsWhoHasJustLeapt) {
  PeopleWatch watch(kBox);
  Mover leaper = mover(0.7, 0.0);
  leaper.leapt = 4.75;
  watch.add(5.0, 0.01, {}, {}, {leaper, mover(0.6, 0.0, 2)});
  ASSERT_EQ(watch.touches().size(), 2U);
  EXPECT_NEAR(watch.touches()[0].since_leap, 0.25, 1e-12);
  EXPECT_TRUE(std::isinf(watch.touches()[1].since_leap));
}

// A corner of the turned outline, by hand: at 45 degrees it reaches 0.7071 m ahead.
TEST(PeopleWatch, TakesTheOutlineAsItIs) {
  PeopleWatch watch(kBox);
  watch.add(1.0, 0.01, {0.0, 0.0, M_PI / 4.0}, {0.5, 0.0}, {mover(1.0072, 0.0)});
  EXPECT_NEAR(watch.closest(), 1.0072 - 0.3 - std::sqrt(0.5), 1e-9);
  EXPECT_TRUE(watch.touches().empty());
  watch.add(1.0, 0.01, {0.0, 0.0, M_PI / 4.0}, {0.5, 0.0}, {mover(1.0070, 0.0)});
  EXPECT_EQ(watch.touches_moving(), 1);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
