// SPDX-License-Identifier: BSD-3-Clause
#include "control/fault_brake.hpp"

#include <gtest/gtest.h>

#include "core/motion/velocity_limits.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kPeriod = 0.05;

/// A brake with 2 m/s^2 and 4 rad/s^2, for a robot that drives 0.5 m/s.
struct Brake {
  Brake() {
    p.max_vel_x = 0.5;
    p.acc_lim_x = 2.0;
    p.acc_lim_theta = 4.0;
  }
  FaultBrake::Command at(double now, const std::optional<Twist2>& velocity, const Twist2& last_command,
                         double period = kPeriod) {
    return brake.brake(now, velocity, last_command, p, VelocityLimits::from(p), period);
  }
  /// The command after `last_command`.
  Twist2 from(const Twist2& last_command) {
    const FaultBrake::Command braking = at(10.0, last_command, last_command);
    EXPECT_TRUE(braking.success);
    return braking.command;
  }
  FaultBrake brake;
  Parameters p;
};

TEST(FaultBrake, OneStepTakesTheLimitTimesThePeriod) {
  Brake brake;
  // 2.0 x 0.05 = 0.1 m/s, 4.0 x 0.05 = 0.2 rad/s.
  EXPECT_DOUBLE_EQ(brake.from({0.5, -1.0}).v, 0.4);
  EXPECT_DOUBLE_EQ(brake.from({0.5, -1.0}).omega, -0.8);
  EXPECT_DOUBLE_EQ(brake.from({-0.3, 0.05}).v, -0.2);
  EXPECT_EQ(brake.from({0.05, 0.05}), Twist2{});
}

TEST(FaultBrake, ADecelerationLimitOfItsOwnCounts) {
  Brake brake;
  brake.p.decel_lim_x = -1.0;  // either sign
  EXPECT_DOUBLE_EQ(brake.from({0.5, 0.0}).v, 0.45);
}

TEST(FaultBrake, BrakesToRestAndThenFails) {
  Brake brake;
  Twist2 command{0.25, 0.5};
  int cycles = 0;
  for (double now = 10.0; cycles < 20; now += kPeriod, ++cycles) {
    const FaultBrake::Command braking = brake.at(now, command, command);
    if (!braking.success) break;
    command = braking.command;
  }
  // v: 0.25, 0.15, 0.05, 0; omega: 0.5, 0.3, 0.1, 0: three commands, then failure.
  EXPECT_EQ(cycles, 3);
  EXPECT_EQ(command, Twist2{});
}

TEST(FaultBrake, ARobotThatRollsOnIsStillBraked) {
  const FaultBrake::Command braking = Brake().at(10.0, Twist2{0.4, 0.0}, {});
  EXPECT_TRUE(braking.success);
  EXPECT_EQ(braking.command, Twist2{});
}

// How fast it is nobody knows: it brakes for 0.5 / 2 = 0.25 s and a period, and no longer.
TEST(FaultBrake, WithoutOdometryTimeDecides) {
  Brake brake;
  const auto brakes = [&brake](double now, const Twist2& last_command) {
    return brake.at(now, std::nullopt, last_command, 0.0625).success;
  };
  EXPECT_TRUE(brakes(10.0, {}));
  EXPECT_TRUE(brakes(10.3125, {}));
  EXPECT_FALSE(brakes(10.3125 + 0x1p-20, {}));
  EXPECT_TRUE(brakes(10.36, {0.0, 0.1}));  // but never in the middle of a braking turn
  brake.brake.clear();
  EXPECT_TRUE(brakes(10.40, {}));
}

}  // namespace
}  // namespace hidwa_local_planner
