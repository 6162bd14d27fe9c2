// SPDX-License-Identifier: BSD-3-Clause
#include "drive/gentleness.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace drive {
namespace {

constexpr double kPeriod = 0.05;  // [s]

TEST(Gentleness, NothingWasDriven) {
  const Gentleness none = GentlenessMeter(3.2).result();
  EXPECT_EQ(none.acc_rms, 0.0);
  EXPECT_EQ(none.acc_p99, 0.0);
  EXPECT_EQ(none.at_limit, 0.0);
}

TEST(Gentleness, IsOfTheCommandsThatAutonomySent) {
  GentlenessMeter meter(3.2);
  meter.add(true, 0.01, kPeriod);   // 0.01 / 0.05 = 0.2 rad/s^2, from 0: 0.2 / 0.05 = 4 rad/s^3; no bend
  meter.add(false, 0.50, kPeriod);  // the person's
  meter.add(true, 0.34, kPeriod);   // -0.16 / 0.05 = -3.2 rad/s^2, the limit; from 9.8: 13 / 0.05 = 260 rad/s^3
  meter.add(true, 0.34, kPeriod);   // 0 rad/s^2; from -3.2: 3.2 / 0.05 = 64 rad/s^3
  const Gentleness result = meter.result();
  EXPECT_NEAR(result.acc_rms, std::sqrt((0.2 * 0.2 + 3.2 * 3.2) / 3.0), 1e-9);
  EXPECT_NEAR(result.acc_p99, 3.2, 1e-9);  // the third of three: ceil(0.99 * 3) = 3
  EXPECT_NEAR(result.bend_acc_rms, std::sqrt(3.2 * 3.2 / 2.0), 1e-9);
  EXPECT_NEAR(result.jerk_rms, std::sqrt((4.0 * 4.0 + 260.0 * 260.0 + 64.0 * 64.0) / 3.0), 1e-6);
  EXPECT_NEAR(result.at_limit, 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(result.bend_at_limit, 1.0 / 2.0, 1e-12);
}

TEST(Gentleness, ThePercentileLeavesOutOneInAHundred) {
  GentlenessMeter meter(3.2);
  double omega = 0.0;
  for (int k = 1; k <= 200; ++k) {
    omega += 0.01 * k * kPeriod;  // accelerations 0.01, 0.02, ... 2.0 rad/s^2
    meter.add(true, omega, kPeriod);
  }
  EXPECT_NEAR(meter.result().acc_p99, 1.98, 1e-9);  // the 198th of 200
}

}  // namespace
}  // namespace drive
}  // namespace hidwa_local_planner
