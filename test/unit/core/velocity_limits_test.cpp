// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/velocity_limits.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

// Accelerates at 2, brakes at 4, between -1 and 1.
constexpr AxisLimits kAxis{-1.0, 1.0, 2.0, 4.0};

struct Ramp {
  const char* what;
  double from, to, time, result;
};

TEST(AxisRamp, AcceleratesAwayFromZeroAndBrakesTowardsIt) {
  const Ramp ramps[] = {
      {"0.2 + 2 * 0.1", 0.2, 1.0, 0.1, 0.4},
      {"-0.2 - 2 * 0.1", -0.2, -1.0, 0.1, -0.4},
      {"accelerates for 0.05 s only", 0.2, 0.3, 0.1, 0.3},
      {"rests", 0.0, 0.0, 0.1, 0.0},
      {"0.9 - 4 * 0.1", 0.9, 0.0, 0.1, 0.5},
      {"-0.9 + 4 * 0.1", -0.9, -0.1, 0.1, -0.5},
      {"brakes for 0.075 s only", 0.3, 0.0, 0.1, 0.0},
      {"brakes, but not to rest", 0.9, 0.8, 0.1, 0.8},
      {"brakes for 0.2 / 4 = 0.05 s, and accelerates for the other 0.05 s", 0.2, -1.0, 0.1, -0.1},
      {"the same from the other side", -0.2, 1.0, 0.1, 0.1},
      {"just rests", 0.2, -1.0, 0.05, 0.0},
      {"brakes before it goes the other way", 0.2, -1.0, 0.025, 0.1},
      {"is there sooner", 0.2, -0.05, 0.1, -0.05},
  };
  for (const Ramp& ramp : ramps) EXPECT_DOUBLE_EQ(kAxis.ramp(ramp.from, ramp.to, ramp.time), ramp.result) << ramp.what;
}

TEST(Reachable, OutsideTheLimitsIsBroughtBackAndNeverEmpty) {
  // 1.8 - 4 * 0.1 = 1.4 is still above 1: the end nearest to the limits alone.
  EXPECT_DOUBLE_EQ(reachable(kAxis, 1.8, 0.1).lo, 1.4);
  EXPECT_DOUBLE_EQ(reachable(kAxis, 1.8, 0.1).hi, 1.4);
  EXPECT_DOUBLE_EQ(reachable(kAxis, -1.8, 0.1).hi, -1.4);
  // 1.2 - 0.4 = 0.8 is inside: from there to the limit.
  EXPECT_DOUBLE_EQ(reachable(kAxis, 1.2, 0.1).lo, 0.8);
  EXPECT_EQ(reachable(kAxis, 1.2, 0.1).hi, 1.0);
  test::Random random(1);
  for (int k = 0; k < 2000; ++k) {
    const double velocity = random.uniform(-20.0, 20.0), dt = random.uniform(1e-4, 3.0);
    const Interval window = reachable(kAxis, velocity, dt);
    ASSERT_LE(window.lo, window.hi) << velocity << " " << dt;
    // Never farther outside than it was.
    ASSERT_LE(std::max(std::abs(window.lo), std::abs(window.hi)), std::max(1.0, std::abs(velocity)));
  }
}

VelocityLimits wheeled() {
  VelocityLimits limits;
  limits.x = {-0.3, 0.5, 2.5, 2.5};
  limits.theta = {-2.0, 2.0, 3.2, 3.2};
  limits.half_separation = 0.2;
  limits.wheel_speed = 0.5;
  return limits;
}

TEST(WheelLimit, IsTheSumOfDrivingAndTurning) {
  const VelocityLimits limits = wheeled();
  EXPECT_TRUE(limits.wheels_allow({0.3, 1.0}));  // 0.3 + 1.0 * 0.2 = 0.5
  EXPECT_FALSE(limits.wheels_allow({0.31, 1.0}));
  EXPECT_TRUE(limits.wheels_allow({-0.3, -1.0}));
  EXPECT_FALSE(limits.wheels_allow({-0.31, 1.0}));
}

TEST(WheelLimit, ClampKeepsTheTurnAndReducesTheSpeed) {
  const VelocityLimits limits = wheeled();
  const Twist2 u = limits.clamp({0.5, 1.5});
  EXPECT_EQ(u.omega, 1.5);
  EXPECT_DOUBLE_EQ(u.v, 0.2);  // 0.5 - 1.5 * 0.2
  EXPECT_DOUBLE_EQ(limits.clamp({-9.0, 1.5}).v, -0.2);
  EXPECT_EQ(limits.clamp({0.5, -9.0}).omega, -2.0);
  // Wheels too slow for the turn itself: 0.3 / 0.2 = 1.5 rad/s on the spot.
  VelocityLimits slow = wheeled();
  slow.wheel_speed = 0.3;
  EXPECT_DOUBLE_EQ(slow.clamp({0.5, -2.0}).omega, -1.5);
  EXPECT_DOUBLE_EQ(slow.clamp({0.5, -2.0}).v, 0.0);
}

TEST(FeasibleStep, AlwaysWithinLimitsWheelsAndAccelerations) {
  const VelocityLimits limits = wheeled();
  test::Random random(2);
  int cut = 0;
  for (int k = 0; k < 20000; ++k) {
    const Twist2 reference = limits.clamp({random.uniform(-0.5, 0.7), random.uniform(-3.0, 3.0)});
    const Twist2 target = limits.clamp({random.uniform(-0.5, 0.7), random.uniform(-3.0, 3.0)});
    const double dt = random.uniform(0.01, 0.3);
    const Twist2 u = limits.step(reference, target, dt);
    cut += u.v != limits.x.ramp(reference.v, target.v, dt);
    ASSERT_TRUE(limits.wheels_allow(u)) << u.v << " " << u.omega;
    ASSERT_LE(std::abs(u.v - reference.v), 2.5 * dt + 1e-12);
    ASSERT_LE(std::abs(u.omega - reference.omega), 3.2 * dt + 1e-12);
    ASSERT_GE(u.v, -0.3);
    ASSERT_LE(u.v, 0.5);
    ASSERT_LE(std::abs(u.omega), 2.0);
  }
  EXPECT_GT(cut, 100);  // the wheels did cut
}

TEST(FeasibleStep, FromBeyondTheWheelsItComesBackAsFastAsTheBrakesAllow) {
  const VelocityLimits limits = wheeled();
  test::Random random(3);
  for (int k = 0; k < 20000; ++k) {
    const Twist2 reference{random.uniform(-0.6, 1.0), random.uniform(-4.0, 4.0)};
    const Twist2 u = limits.step(reference, limits.clamp({random.uniform(-0.5, 0.7), random.uniform(-3.0, 3.0)}), 0.05);
    ASSERT_LE(std::abs(u.v - reference.v), 2.5 * 0.05 + 1e-12);
    ASSERT_LE(std::abs(u.omega - reference.omega), 3.2 * 0.05 + 1e-12);
    if (limits.wheels_allow(u)) continue;
    // Too fast still: then both axes brake fully.
    const Twist2 brake = limits.brake(reference, 0.05);
    ASSERT_NEAR(u.v, brake.v, 1e-12) << reference.v << " " << reference.omega;
    ASSERT_NEAR(u.omega, brake.omega, 1e-12);
  }
}

}  // namespace
}  // namespace hidwa_local_planner
