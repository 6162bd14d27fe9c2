// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/brake_manoeuvre.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/command_history.hpp"
#include "support/naive_manoeuvre.hpp"
#include "support/naive_reference.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

VelocityLimits limits(double braking_x, double braking_theta) {
  VelocityLimits l;
  l.x = {-2.0, 2.0, 2.5, braking_x};
  l.theta = {-3.0, 3.0, 3.2, braking_theta};
  return l;
}

std::vector<Pose2> poses(const BrakeManoeuvre& m, const VelocityLimits& l, double radius = 0.3,
                         double spacing = 0.025) {
  std::vector<Pose2> out;
  roll_out(m, l, radius, spacing, out);
  return out;
}

// The last of braking, what takes half a period at the limit, is done evenly over a period: with a limit b and a period T that
// is b T / 2 over T instead of T / 2, b T^2 / 8 more.
double tail(double braking) { return braking * 0.05 * 0.05 / 8.0; }

TEST(BrakeManoeuvreDistance, StraightOn) {
  // 0.1 s at 0.5, 0.05 s from 0.5 to 0.4, then 0.4^2 / (2 * 2) and the tail.
  const UnderWay steady({0.5, 0.0}, 0.1);
  const std::vector<Pose2> path = poses({{1.0, 2.0, 0.0}, steady, {0.4, 0.0}, 0.05}, limits(2.0, 3.0));
  EXPECT_NEAR(path.back().x - 1.0, 0.05 + 0.0225 + 0.04 + tail(2.0), 1e-12);
  EXPECT_EQ(path.back().y, 2.0);
}

TEST(BrakeManoeuvreDistance, ALateCommandToBrakeLetsItGoOn) {
  // 0.05 s at 0.4, 0.03 s more, then 0.4^2 / (2 * 2).
  const UnderWay steady({0.4, 0.0}, 0.0);
  const BrakeManoeuvre late{{}, steady, {0.4, 0.0}, 0.05, 0.03};
  EXPECT_NEAR(poses(late, limits(2.0, 3.0)).back().x, 0.02 + 0.012 + 0.04 + tail(2.0), 1e-12);
  // Two periods and the hold at 0.4, and the way to rest.
  EXPECT_NEAR(late.reach(limits(2.0, 3.0)), 0.4 * 0.13 + 0.04, 1e-12);
}

TEST(BrakeManoeuvreDistance, TheTailOfASlowRobotIsAllOfIt) {
  // From 0.03 m/s, less than 2 * 0.05 / 2: 0.05 s at it, and evenly over 0.05 s.
  const UnderWay steady({0.03, 0.0}, 0.0);
  EXPECT_NEAR(poses({{}, steady, {0.03, 0.0}, 0.05}, limits(2.0, 3.0)).back().x, 0.0015 + 0.00075, 1e-12);
}

TEST(BrakeManoeuvreDistance, WhatIsUnderWayTakesEffectFirst) {
  // It has begun to brake at 2.5 m/s^2 and the robot does not yet: 0.5^2 / (2 * 2.5) = 0.05 m from here, of which
  // 0.05 * (0.4375 + 0.3125) = 0.0375 m within the latency. The last command alone would have said 0.1 * 0.25.
  UnderWay braking;
  braking.begin({0.5, 0.0});
  braking.add({0.375, 0.0}, 0.05);
  braking.add({0.25, 0.0}, 0.05);
  const BrakeManoeuvre m{{}, braking, {0.125, 0.0}, 0.05};
  EXPECT_NEAR(poses(m, limits(2.5, 3.0)).back().x, 0.05 + tail(2.5), 1e-12);
  // The faster end of each leg: 0.05 * (0.5 + 0.375); two periods at 0.25, and 0.25^2 / 5.
  EXPECT_NEAR(m.reach(limits(2.5, 3.0)), 0.04375 + 0.025 + 0.0125, 1e-12);
}

TEST(BrakeManoeuvreDistance, ATurnUnderWayCounts) {
  // 0.1 s from 1 to 0.68 rad/s, 0.05 s to 0.52, then 0.52^2 / (2 * 3.2): 0.084 + 0.03 + 0.04225 rad.
  UnderWay straightening;
  straightening.begin({0.0, 1.0});
  straightening.add({0.0, 0.68}, 0.1);
  EXPECT_NEAR(poses({{}, straightening, {0.0, 0.52}, 0.05}, limits(2.0, 3.2)).back().theta, 0.15625 + tail(3.2), 1e-12);
}

TEST(BrakeManoeuvreDistance, SpeedingUpIsDoneAtTheLimit) {
  // From 0.4 to 0.45 at 2.5 m/s^2 in 0.02 s, 0.03 s at 0.45, then 0.45^2 / (2 * 2).
  const UnderWay steady({0.4, 0.0}, 0.0);
  const double way = 0.0085 + 0.0135 + 0.050625 + tail(2.0);
  EXPECT_NEAR(poses({{}, steady, {0.45, 0.0}, 0.05}, limits(2.0, 3.0)).back().x, way, 1e-12);
  // Both axes, each in its own time: 0.16 rad/s at 3.2 rad/s^2 take the whole period.
  const Pose2 end = poses({{}, steady, {0.45, 0.16}, 0.05}, limits(2.0, 3.2), 0.3, 1e-4).back();
  EXPECT_NEAR(end.theta, 0.05 * 0.08 + 0.16 * 0.16 / 6.4 + tail(3.2), 1e-12);
  EXPECT_NEAR(std::hypot(end.x, end.y), way, 1e-5);
}

TEST(BrakeManoeuvreDistance, FromOneDirectionToTheOther) {
  // From -0.05 evenly to 0.05 it gets nowhere; then, all of it tail, evenly to rest: 0.05 * 0.05 / 2.
  const UnderWay steady({-0.05, 0.0}, 0.0);
  EXPECT_NEAR(poses({{}, steady, {0.05, 0.0}, 0.05}, limits(2.0, 3.0), 0.3, 1e-5).back().x, 0.00125, 1e-12);
}

TEST(BrakeManoeuvreDistance, TurnOnTheSpotStopsAtItsOwnLimit) {
  // 0.1 * 1.0, 0.05 s from 1 to 0.92 at 1.6 rad/s^2, 0.92^2 / (2 * 1.6) = 0.2645 rad.
  const UnderWay steady({0.0, 1.0}, 0.1);
  const double turn = 0.1 + 0.048 + 0.2645 + tail(1.6);
  EXPECT_NEAR(poses({{}, steady, {0.0, 0.92}, 0.05}, limits(2.0, 1.6)).back().theta, turn, 1e-12);
  // No command brakes it faster: it is on its way to 0.8 yet when the next one takes effect, and that starts from 0.92 too.
  EXPECT_NEAR(poses({{}, steady, {0.0, 0.8}, 0.05}, limits(2.0, 1.6)).back().theta, turn, 1e-12);
  EXPECT_EQ(poses({{}, steady, {0.0, 0.8}, 0.05}, limits(2.0, 1.6)).back().x, 0.0);
}

TEST(BrakeManoeuvreDistance, AtRestItDoesNotMove) {
  const UnderWay rest({}, 0.5);
  EXPECT_TRUE(poses({{1.0, 2.0, 0.3}, rest, {}, 0.05}, limits(2.0, 3.0)).empty());
}

Twist2 random_velocity(test::Random& random) { return {random.uniform(-0.3, 1.0), random.uniform(-2.0, 2.0)}; }

UnderWay random_way(test::Random& random) {
  UnderWay way;
  way.begin(random_velocity(random));
  for (int legs = random.integer(0, 3); legs > 0; --legs) {
    way.add(random.chance(0.3) ? way.end() : random_velocity(random), random.uniform(0.0, 0.1));
  }
  return way;
}

TEST(BrakeManoeuvrePoses, NoPointOfTheRobotMovesFartherThanTheSpacing) {
  test::Random random(7);
  for (int k = 0; k < 300; ++k) {
    const UnderWay way = random_way(random);
    const BrakeManoeuvre m{{0.0, 0.0, random.uniform(-3.0, 3.0)}, way, random_velocity(random), 0.05};
    const double radius = random.uniform(0.1, 0.6);
    Pose2 before = m.start;
    for (const Pose2& pose : poses(m, limits(1.0, 2.0), radius, 0.02)) {
      for (int a = 0; a < 8; ++a) {  // points on the outer circle
        const double angle = M_PI / 4 * a;
        const double dx = pose.x + radius * std::cos(pose.theta + angle) - before.x -
                          radius * std::cos(before.theta + angle);
        const double dy = pose.y + radius * std::sin(pose.theta + angle) - before.y -
                          radius * std::sin(before.theta + angle);
        ASSERT_LE(std::hypot(dx, dy), 0.02 + 1e-9);
      }
      ASSERT_LE(std::hypot(pose.x, pose.y), m.reach(limits(1.0, 2.0)) + 1e-9);
      before = pose;
    }
  }
}

TEST(BrakeManoeuvrePoses, EndsWhereAFineIntegrationEnds) {
  test::Random random(8);
  Parameters p;
  p.acc_lim_x = 2.5;
  p.acc_lim_theta = 3.2;
  p.decel_lim_x = -1.0;
  p.decel_lim_theta = -2.0;
  const VelocityLimits l = VelocityLimits::from(p);
  constexpr double kPeriod = 0.05;
  for (int k = 0; k < 300; ++k) {
    p.control_latency = random.uniform(0.0, 0.3);
    CommandHistory history;
    std::vector<test::NaiveCycle> cycles{{0.0, kPeriod, random_velocity(random), {}, 0.0}};
    for (int cycle = 0; cycle < 10; ++cycle) {
      if (cycle > 0) {
        const double late = random.chance(0.2) ? random.uniform(-0.02, 0.05) : 0.0;
        const Twist2 next = l.step(cycles.back().last_command, random_velocity(random), kPeriod);
        cycles.push_back({cycles.back().time + kPeriod + late, kPeriod, next, {}, 0.0});
      }
      history.observe(cycles.back().time, kPeriod, p.control_latency + kPeriod, cycles.back().last_command, l);
    }
    UnderWay under_way;
    history.play(l, kPeriod, p.control_latency, 0.0, under_way);
    const Pose2 start{0.3, -0.2, random.uniform(-3.0, 3.0)};
    const double hold = random.chance(0.5) ? 0.0 : random.uniform(0.0, 0.1);
    const Twist2 command = l.step(history.last(), random_velocity(random), kPeriod);
    const Pose2 end = poses({start, under_way, command, kPeriod, hold}, l, 0.3, 1e-4).back();
    const test::NaiveHistory twin(p, cycles);
    const test::NaiveManoeuvre naive = test::naive_manoeuvre(p, start, twin.effects(), command, kPeriod, hold);
    const Pose2 fine = test::naive_poses(naive, 0.3, 0.005).back();
    ASSERT_NEAR(end.x, fine.x, 1e-4) << k;
    ASSERT_NEAR(end.y, fine.y, 1e-4) << k;
    ASSERT_NEAR(end.theta, fine.theta, 1e-4) << k;
  }
}

}  // namespace
}  // namespace hidwa_local_planner
