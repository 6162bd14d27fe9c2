// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "sim/social_force.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

// Helbing and Molnar 1995, eqs. 3 and 4, as they are written: V = 2.1 exp(-b / 0.3).
double potential(const Eigen::Vector2d& away, const Eigen::Vector2d& other) {
  const Eigen::Vector2d step = 2.0 * other;
  const double sum = away.norm() + (away - step).norm();
  return 2.1 * std::exp(-0.5 * std::sqrt(sum * sum - step.squaredNorm()) / 0.3);
}

TEST(SocialForce, RepulsionIsTheSlopeOfThePotential) {
  constexpr double kH = 1e-6;
  for (const Eigen::Vector2d& away :
       {Eigen::Vector2d(0.6, 0.2), Eigen::Vector2d(-0.3, 0.9), Eigen::Vector2d(1.2, -0.4)}) {
    for (const Eigen::Vector2d& other : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.8, 0.3)}) {
      const Eigen::Vector2d x(kH, 0.0), y(0.0, kH);
      const Eigen::Vector2d slope((potential(away + x, other) - potential(away - x, other)) / (2.0 * kH),
                                  (potential(away + y, other) - potential(away - y, other)) / (2.0 * kH));
      EXPECT_NEAR((repulsion(away, other) + slope).norm(), 0.0, 1e-6);
    }
  }
  // From one who stands: b = |away|, 2.1 / 0.3 exp(-0.6 / 0.3).
  EXPECT_NEAR(repulsion({0.6, 0.0}, {0.0, 0.0}).x(), 7.0 * std::exp(-2.0), 1e-9);
  EXPECT_TRUE(repulsion({0.0, 0.0}, {0.0, 0.0}).allFinite());
}

TEST(SocialForce, DriveWallAndSight) {
  EXPECT_NEAR(drive_force({0.4, 0.0}, {1.0, 0.0}).x(), 0.6 / 0.5, 1e-12);
  EXPECT_NEAR(wall_force(0.4, {0.0, 1.0}).y(), 50.0 * std::exp(-2.0), 1e-12);
  // A force from ahead pushes back; from straight behind, and from 120 degrees, it counts half.
  EXPECT_EQ(sight({1.0, 0.0}, {-2.0, 0.0}), 1.0);
  EXPECT_EQ(sight({1.0, 0.0}, {2.0, 0.0}), 0.5);
  EXPECT_EQ(sight({1.0, 0.0}, {-std::cos(2.0 * M_PI / 3.0), std::sin(2.0 * M_PI / 3.0)}), 0.5);
  EXPECT_EQ(sight({1.0, 0.0}, {-std::cos(M_PI / 2.0), std::sin(M_PI / 2.0)}), 1.0);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
