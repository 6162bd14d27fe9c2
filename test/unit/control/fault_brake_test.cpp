// SPDX-License-Identifier: BSD-3-Clause
#include "control/fault_brake.hpp"

#include <gtest/gtest.h>

#include "core/motion/velocity_limits.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kPeriod = 0.05;

Parameters braking(double x, double theta) {
  Parameters p;
  p.max_vel_x = 0.5;
  p.acc_lim_x = x;
  p.acc_lim_theta = theta;
  return p;
}

FaultBrake::Command brake_by(FaultBrake& brake, double now, const std::optional<Twist2>& velocity,
                             const Twist2& last_command, const Parameters& p, double period) {
  return brake.brake(now, velocity, last_command, p, VelocityLimits::from(p), period);
}

/// The command after `last_command`.
Twist2 brake_from(const Twist2& last_command, const Parameters& p) {
  FaultBrake brake;
  const FaultBrake::Command braking = brake_by(brake, 10.0, last_command, last_command, p, kPeriod);
  EXPECT_TRUE(braking.success);
  return braking.command;
}

TEST(FaultBrake, OneStepTakesTheLimitTimesThePeriod) {
  const Parameters p = braking(2.0, 4.0);
  // 2.0 x 0.05 = 0.1 m/s, 4.0 x 0.05 = 0.2 rad/s.
  EXPECT_DOUBLE_EQ(brake_from({0.5, -1.0}, p).v, 0.4);
  EXPECT_DOUBLE_EQ(brake_from({0.5, -1.0}, p).omega, -0.8);
  EXPECT_DOUBLE_EQ(brake_from({-0.3, 0.05}, p).v, -0.2);
  EXPECT_EQ(brake_from({0.05, 0.05}, p), Twist2{});
}

TEST(FaultBrake, ADecelerationLimitOfItsOwnCounts) {
  Parameters p = braking(2.0, 4.0);
  p.decel_lim_x = -1.0;  // either sign
  EXPECT_DOUBLE_EQ(brake_from({0.5, 0.0}, p).v, 0.45);
}

TEST(FaultBrake, AtRestItFails) {
  FaultBrake brake;
  EXPECT_FALSE(brake_by(brake, 10.0, Twist2{}, Twist2{}, Parameters(), kPeriod).success);
}

// Without a measured velocity it brakes for 0.5 / 2 = 0.25 s and a period, and no longer.
TEST(FaultBrake, HowFastItIsUnknownItBrakesUntilItMustRest) {
  FaultBrake brake;
  const Parameters p = braking(2.0, 4.0);
  const auto brakes = [&](double now) { return brake_by(brake, now, {}, Twist2{}, p, 0.0625).success; };
  EXPECT_TRUE(brakes(10.0));
  EXPECT_TRUE(brakes(10.3125));
  EXPECT_FALSE(brakes(10.3125 + 0x1p-20));
}

TEST(FaultBrake, BrakesToRestAndThenFails) {
  FaultBrake brake;
  const Parameters p = braking(2.0, 4.0);
  Twist2 command{0.25, 0.5};
  int cycles = 0;
  for (double now = 10.0; cycles < 20; now += kPeriod, ++cycles) {
    const FaultBrake::Command braking = brake_by(brake, now, command, command, p, kPeriod);
    if (!braking.success) break;
    command = braking.command;
  }
  // v: 0.25, 0.15, 0.05, 0; omega: 0.5, 0.3, 0.1, 0: three commands, then failure.
  EXPECT_EQ(cycles, 3);
  EXPECT_EQ(command, Twist2{});
}

TEST(FaultBrake, ARobotThatRollsOnIsStillBraked) {
  FaultBrake brake;
  const FaultBrake::Command braking = brake_by(brake, 10.0, Twist2{0.4, 0.0}, Twist2{}, Parameters(), kPeriod);
  EXPECT_TRUE(braking.success);
  EXPECT_EQ(braking.command, Twist2{});
}

TEST(FaultBrake, WithoutOdometryTimeDecides) {
  FaultBrake brake;
  const Parameters p = braking(2.0, 4.0);
  // 0.5 / 2.0 + 0.05 = 0.30 s
  EXPECT_TRUE(brake_by(brake, 10.0, std::nullopt, Twist2{}, p, kPeriod).success);
  EXPECT_TRUE(brake_by(brake, 10.29, std::nullopt, Twist2{}, p, kPeriod).success);
  EXPECT_FALSE(brake_by(brake, 10.31, std::nullopt, Twist2{}, p, kPeriod).success);
  // But never in the middle of a braking turn.
  EXPECT_TRUE(brake_by(brake, 10.36, std::nullopt, Twist2{0.0, 0.1}, p, kPeriod).success);
  brake.clear();
  EXPECT_TRUE(brake_by(brake, 10.40, std::nullopt, Twist2{}, p, kPeriod).success);
}

}  // namespace
}  // namespace hidwa_local_planner
