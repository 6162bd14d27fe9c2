// SPDX-License-Identifier: BSD-3-Clause
#include "sim/diff_drive.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace sim {
namespace {

TEST(Ramp, ReachesTheTargetAtTheAcceleration) {
  // From 0 to 0.5 at 2.5: 0.2 s and 0.05 m; then 0.3 s at 0.5: 0.15 m.
  double speed = 0.0;
  EXPECT_NEAR(ramp(speed, 0.5, 2.5, 1.0, 0.5), 0.05 + 0.15, 1e-12);
  EXPECT_DOUBLE_EQ(speed, 0.5);
}

TEST(Ramp, SlowsAtTheDecelerationAndReversesThroughZero) {
  // From 0.5 at 1.0 to rest: 0.5 s, 0.125 m; then to -0.5 at 2.5 for 0.1 s: -0.25, -0.0125 m.
  double speed = 0.5;
  EXPECT_NEAR(ramp(speed, -0.5, 2.5, 1.0, 0.6), 0.125 - 0.0125, 1e-12);
  EXPECT_NEAR(speed, -0.25, 1e-12);
}

TEST(Ramp, ManySmallStepsEqualOneLarge) {
  double coarse = 0.3;
  double fine = 0.3;
  const double whole = ramp(coarse, -0.4, 2.0, 3.0, 0.2);
  double sum = 0.0;
  for (int i = 0; i < 200; ++i) sum += ramp(fine, -0.4, 2.0, 3.0, 0.001);
  EXPECT_NEAR(sum, whole, 1e-12);
  EXPECT_NEAR(fine, coarse, 1e-12);
}

TEST(Arc, QuarterCircle) {
  // Radius 2: the quarter is pi long and ends at (2, 2), heading up.
  const Pose end = moved({0, 0, 0}, {M_PI, M_PI / 2});
  EXPECT_NEAR(end.x, 2.0, 1e-12);
  EXPECT_NEAR(end.y, 2.0, 1e-12);
  EXPECT_NEAR(end.theta, M_PI / 2, 1e-12);
}

TEST(Arc, NearlyStraightIsAsExact) {
  const Pose end = moved({0, 0, 0}, {1.0, 1e-5});
  EXPECT_NEAR(end.x, std::sin(1e-5) / 1e-5, 1e-15);
  EXPECT_NEAR(end.y, 0.5e-5, 1e-12);
}

DriveLimits limits_without_timeout() {
  DriveLimits limits;
  limits.command_timeout = 0.0;
  return limits;
}

TEST(DiffDrive, CommandsAreLimited) {
  DiffDrive drive(limits_without_timeout());
  drive.command({9.0, -9.0}, 0.0);
  drive.step(0.0, 1.0);
  EXPECT_DOUBLE_EQ(drive.velocity().v, 0.5);
  EXPECT_DOUBLE_EQ(drive.velocity().omega, -1.0);
  drive.command({std::numeric_limits<double>::quiet_NaN(), 0.5}, 1.0);
  drive.step(1.0, 1.0);
  EXPECT_DOUBLE_EQ(drive.velocity().v, 0.0);
  EXPECT_DOUBLE_EQ(drive.velocity().omega, 0.5);
}

TEST(DiffDrive, WheelLimitKeepsTheCurve) {
  DriveLimits limits = limits_without_timeout();
  limits.wheel_separation = 0.4;
  limits.max_wheel_speed = 0.35;
  DiffDrive drive(limits);
  // The faster wheel would need 0.5 + 0.2 = 0.7 m/s and has 0.35: half of both.
  drive.command({0.5, 1.0}, 0.0);
  drive.step(0.0, 1.0);
  EXPECT_NEAR(drive.velocity().v, 0.25, 1e-12);
  EXPECT_NEAR(drive.velocity().omega, 0.5, 1e-12);
}

TEST(DiffDrive, CommandsTakeEffectAfterTheLatency) {
  DriveLimits limits = limits_without_timeout();
  limits.latency = 0.1;
  DiffDrive drive(limits);
  drive.command({0.5, 0.0}, 0.0);
  for (int i = 0; i < 10; ++i) EXPECT_DOUBLE_EQ(drive.step(0.01 * i, 0.01).distance, 0.0) << i;
  // At 0.10 s: 0.5 x 2.5 x 0.01^2.
  EXPECT_NEAR(drive.step(0.10, 0.01).distance, 1.25e-4, 1e-12);
}

TEST(DiffDrive, BrakesWhenCommandsStop) {
  DriveLimits limits;
  limits.command_timeout = 0.3;
  DiffDrive drive(limits);
  drive.command({0.5, 0.0}, 0.0);
  for (int i = 0; i <= 30; ++i) drive.step(0.01 * i, 0.01);
  EXPECT_DOUBLE_EQ(drive.velocity().v, 0.5);
  // From 0.31 s it slows at 2.5: after 0.1 s 0.25, after 0.2 s 0.
  for (int i = 31; i < 41; ++i) drive.step(0.01 * i, 0.01);
  EXPECT_NEAR(drive.velocity().v, 0.25, 1e-12);
  for (int i = 41; i < 52; ++i) drive.step(0.01 * i, 0.01);
  EXPECT_DOUBLE_EQ(drive.velocity().v, 0.0);
}

TEST(DiffDrive, SenselessLimitsAreRefused) {
  DriveLimits limits;
  limits.acc_lim_x = 0.0;
  EXPECT_THROW(DiffDrive{limits}, std::invalid_argument);
  limits = DriveLimits();
  limits.max_wheel_speed = 0.5;  // without wheels
  EXPECT_THROW(DiffDrive{limits}, std::invalid_argument);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
