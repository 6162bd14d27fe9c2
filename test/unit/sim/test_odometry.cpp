// SPDX-License-Identifier: BSD-3-Clause
#include "sim/odometry.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace sim {
namespace {

TEST(Odometry, WithoutNoiseIsExact) {
  Odometry odometry(OdometryNoise(), 1);
  Pose truth;
  for (int i = 0; i < 1000; ++i) {
    const Motion motion{0.005, 0.003 * std::sin(0.01 * i)};
    truth = moved(truth, motion);
    odometry.step(motion, {0.5, 0.1}, 0.01);
  }
  EXPECT_DOUBLE_EQ(odometry.pose().x, truth.x);
  EXPECT_DOUBLE_EQ(odometry.pose().theta, truth.theta);
  EXPECT_DOUBLE_EQ(odometry.velocity().v, 0.5);
}

TEST(Odometry, SlipIsProportionalAndSeeded) {
  OdometryNoise noise;
  noise.slip_x = 0.1;
  // 2000 draws of 0.5 s each at 0.5 m/s: 500 m. The error's standard deviation is 0.1 x 0.25 m x sqrt(2000)
  // = 1.12 m.
  const auto reported = [&](std::uint64_t seed) {
    Odometry odometry(noise, seed);
    for (int i = 0; i < 100000; ++i) odometry.step({0.005, 0.0}, {0.5, 0.0}, 0.01);
    return odometry.pose().x;
  };
  const double x = reported(3);
  EXPECT_NE(x, 500.0);
  EXPECT_NEAR(x, 500.0, 4.0 * 1.12);
  EXPECT_DOUBLE_EQ(x, reported(3));
  EXPECT_NE(x, reported(4));
}

TEST(Odometry, ARobotAtRestDoesNotDrift) {
  OdometryNoise noise;
  noise.slip_x = noise.slip_theta = 0.2;
  Odometry odometry(noise, 1);
  for (int i = 0; i < 1000; ++i) odometry.step(Motion(), Velocity(), 0.01);
  EXPECT_EQ(odometry.pose().x, 0.0);
  EXPECT_EQ(odometry.pose().theta, 0.0);
}

TEST(Odometry, NegativeSlipIsRefused) {
  OdometryNoise noise;
  noise.slip_x = -0.1;
  EXPECT_THROW(Odometry(noise, 1), std::invalid_argument);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
