// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/brake_manoeuvre.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/naive_manoeuvre.hpp"
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

TEST(BrakeManoeuvreDistance, StraightOn) {
  // 0.1 s at 0.5, 0.05 s from 0.5 to 0.4, then 0.4^2 / (2 * 2).
  const std::vector<Pose2> path =
      poses({{1.0, 2.0, 0.0}, {0.5, 0.0}, {0.4, 0.0}, 0.1, 0.05}, limits(2.0, 3.0));
  EXPECT_NEAR(path.back().x - 1.0, 0.05 + 0.0225 + 0.04, 1e-12);
  EXPECT_EQ(path.back().y, 2.0);
}

TEST(BrakeManoeuvreDistance, TurnOnTheSpotStopsAtItsOwnLimit) {
  // 0.1 * 1.0 + 0.05 * 0.9 + 0.8^2 / (2 * 1.6) = 0.1 + 0.045 + 0.2 rad.
  const std::vector<Pose2> path = poses({{}, {0.0, 1.0}, {0.0, 0.8}, 0.1, 0.05}, limits(2.0, 1.6));
  EXPECT_NEAR(path.back().theta, 0.345, 1e-12);
  EXPECT_EQ(path.back().x, 0.0);
}

TEST(BrakeManoeuvreDistance, AtRestItDoesNotMove) {
  EXPECT_TRUE(poses({{1.0, 2.0, 0.3}, {}, {}, 0.5, 0.05}, limits(2.0, 3.0)).empty());
}

TEST(BrakeManoeuvrePoses, NoPointOfTheRobotMovesFartherThanTheSpacing) {
  test::Random random(7);
  for (int k = 0; k < 300; ++k) {
    const BrakeManoeuvre m{{0.0, 0.0, random.uniform(-3.0, 3.0)},
                           {random.uniform(-0.3, 1.0), random.uniform(-2.0, 2.0)},
                           {random.uniform(-0.3, 1.0), random.uniform(-2.0, 2.0)},
                           random.uniform(0.0, 0.3),
                           0.05};
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
      before = pose;
    }
  }
}

TEST(BrakeManoeuvrePoses, EndsWhereAFineIntegrationEnds) {
  test::Random random(8);
  for (int k = 0; k < 300; ++k) {
    const BrakeManoeuvre m{{0.3, -0.2, random.uniform(-3.0, 3.0)},
                           {random.uniform(-0.3, 1.0), random.uniform(-2.0, 2.0)},
                           {random.uniform(-0.3, 1.0), random.uniform(-2.0, 2.0)},
                           random.uniform(0.0, 0.3),
                           0.05};
    const std::vector<Pose2> path = poses(m, limits(1.0, 2.0), 0.3, 0.005);
    const Pose2 naive =
        test::naive_poses({m.start, m.reference, m.command, m.latency, m.period, 1.0, 2.0}, 0.3, 0.005)
            .back();
    ASSERT_NEAR(path.back().x, naive.x, 1e-4);
    ASSERT_NEAR(path.back().y, naive.y, 1e-4);
    ASSERT_NEAR(path.back().theta, naive.theta, 1e-4);
  }
}

}  // namespace
}  // namespace hidwa_local_planner
