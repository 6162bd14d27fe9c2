// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/rollout.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

Parameters coarse(Method method) {
  Parameters p;
  p.method = method;
  p.generator = Generator::dwa;
  p.sim_time = 1.0;
  p.linear_granularity = 1.0;
  p.angular_granularity = 1.0;
  return p;
}

Rollout run(const Parameters& p, const Pose2& start, const Twist2& reference, const std::vector<Sample>& samples) {
  Rollout rollout;
  CycleStart from;
  from.pose = start;
  from.reference = reference;
  from.limits = VelocityLimits::from(p);
  rollout.run(p, from, samples);
  return rollout;
}

TEST(RolloutSteps, Nav2sNumber) {
  Parameters p;
  p.method = Method::paper;
  p.angular_granularity = 0.025;
  p.sim_time = 1.7;
  // ceil(0.5 * 1.7 / 0.05) = 17; ceil(1 * 1.7 / 0.025) = 68; at least 1.
  EXPECT_EQ(run(p, {}, {}, {{{0.5, 0.0}, SampleKind::grid}}).tile(0).steps, 17u);
  EXPECT_EQ(run(p, {}, {}, {{{0.5, -1.0}, SampleKind::grid}}).tile(0).steps, 68u);
  EXPECT_EQ(run(p, {}, {}, {{{0.0, 0.0}, SampleKind::grid}}).tile(0).steps, 1u);
  EXPECT_DOUBLE_EQ(run(p, {}, {}, {{{0.5, 0.0}, SampleKind::grid}}).tile(0).dt, 0.1);
}

TEST(RolloutSteps, EulerCandidatesHaveTheirOwnMidpointOnesThoseOfTheFastest) {
  const std::vector<Sample> samples = {{{0.1, 0.2}, SampleKind::grid}, {{0.5, 0.2}, SampleKind::grid}};
  Parameters p;
  p.method = Method::paper;
  p.angular_granularity = 0.025;
  p.sim_time = 1.7;
  const Rollout euler = run(p, {}, {}, samples);
  ASSERT_EQ(euler.tile_count(), 2u);
  EXPECT_EQ(euler.tile(0).steps, 14u);  // ceil(0.2 * 1.7 / 0.025) = ceil(13.6)
  EXPECT_EQ(euler.tile(1).steps, 17u);
  p.method = Method::hidwa;
  const Rollout midpoint = run(p, {}, {}, samples);
  ASSERT_EQ(midpoint.tile_count(), 1u);
  EXPECT_EQ(midpoint.tile(0).steps, 17u);
  EXPECT_EQ(midpoint.tile(0).count, 2u);
}

TEST(RolloutArithmetic, EulerTakesTheHeadingAtTheStepsStart) {
  // 2 steps of 0.5 s: ceil(1 * 1 / 0.5). The first goes straight along +x, the second at 0.5 rad.
  Parameters p = coarse(Method::paper);
  p.angular_granularity = 0.5;
  const Rollout rollout = run(p, {1.0, 2.0, 0.0}, {}, {{{0.4, 1.0}, SampleKind::grid}});
  const Tile tile = rollout.tile(0);
  ASSERT_EQ(tile.steps, 2u);
  EXPECT_DOUBLE_EQ(tile.x_at(1, 0), 1.2);
  EXPECT_DOUBLE_EQ(tile.y_at(1, 0), 2.0);
  EXPECT_NEAR(tile.x_at(2, 0), 1.2 + 0.2 * std::cos(0.5), 1e-15);
  EXPECT_NEAR(tile.y_at(2, 0), 2.0 + 0.2 * std::sin(0.5), 1e-15);
  EXPECT_DOUBLE_EQ(tile.heading[2], 1.0);
}

TEST(RolloutArithmetic, MidpointTakesTheHeadingInTheStepsMiddle) {
  Parameters p = coarse(Method::hidwa);
  p.angular_granularity = 0.5;
  const Rollout rollout = run(p, {1.0, 2.0, 0.3}, {}, {{{0.4, 1.0}, SampleKind::grid}});
  const Tile tile = rollout.tile(0);
  EXPECT_NEAR(tile.x_at(2, 0), 1.0 + 0.2 * std::cos(0.55) + 0.2 * std::cos(1.05), 1e-15);
  EXPECT_NEAR(tile.y_at(2, 0), 2.0 + 0.2 * std::sin(0.55) + 0.2 * std::sin(1.05), 1e-15);
  EXPECT_NEAR(tile.cos_heading[1], std::cos(0.8), 1e-15);
  EXPECT_NEAR(tile.sin_heading[2], std::sin(1.3), 1e-15);
}

TEST(RolloutArithmetic, MidpointEndsOnTheArc) {
  Parameters p;
  p.sim_time = 1.7;
  p.generator = Generator::dwa;
  const Rollout rollout = run(p, {}, {}, {{{0.5, 1.0}, SampleKind::grid}});
  const Pose2 end = rollout.tile(0).last_pose(0);
  // Radius 0.5 m, angle 1.7 rad. Steps at the middle's heading of 0.1 rad are long by 0.1^2 / 24 = 4.2e-4: 0.2 mm of
  // the radius, 0.4 mm at the far side of the circle.
  EXPECT_NEAR(end.x, 0.5 * std::sin(1.7), 4e-4);
  EXPECT_NEAR(end.y, 0.5 * (1.0 - std::cos(1.7)), 4e-4);
  EXPECT_NEAR(end.theta, 1.7, 1e-12);
}

TEST(RolloutRamp, StandardRampsFromTheReferenceEuler) {
  Parameters p = coarse(Method::paper);
  p.generator = Generator::standard;
  p.linear_granularity = 0.1;  // ceil(0.4 * 1 / 0.1) = 4 steps of 0.25 s
  p.acc_lim_x = 1.0;
  const Rollout rollout = run(p, {}, {0.0, 0.0}, {{{0.4, 0.0}, SampleKind::grid}});
  const Tile tile = rollout.tile(0);
  ASSERT_EQ(tile.steps, 4u);
  // Velocities after each step's ramp: 0.25, 0.4, 0.4, 0.4.
  EXPECT_DOUBLE_EQ(tile.x_at(1, 0), 0.0625);
  EXPECT_DOUBLE_EQ(tile.x_at(4, 0), 0.25 * (0.25 + 0.4 + 0.4 + 0.4));
}

TEST(RolloutRamp, StandardRampsFromTheReferenceMidpoint) {
  Parameters p = coarse(Method::hidwa);
  p.generator = Generator::standard;
  p.linear_granularity = 0.1;
  p.acc_lim_x = 1.0;
  p.acc_lim_theta = 1.0;
  const Rollout rollout = run(p, {}, {0.0, 0.0}, {{{0.4, 0.3}, SampleKind::grid}});
  const Tile tile = rollout.tile(0);
  ASSERT_EQ(tile.steps, 4u);
  // Mean speeds 0.125, 0.325, 0.4, 0.4; turns 0.25 * (0.125, 0.275, 0.3, 0.3); headings in the middle of each
  // step.
  const double first = 0.25 * 0.125, second = 0.25 * 0.275, whole = 0.25 * 0.3;
  const double headings[] = {first / 2, first + second / 2, first + second + whole / 2,
                             first + second + whole + whole / 2};
  const double speeds[] = {0.125, 0.325, 0.4, 0.4};
  double x = 0.0, y = 0.0;
  for (int k = 0; k < 4; ++k) {
    // The middle's heading is taken at a quarter of the sum of both ends' velocities: exact for an even ramp.
    x += 0.25 * speeds[k] * std::cos(headings[k]);
    y += 0.25 * speeds[k] * std::sin(headings[k]);
  }
  EXPECT_NEAR(tile.heading[4], first + second + 2 * whole, 1e-15);
  EXPECT_NEAR(tile.x_at(4, 0), x, 1e-15);
  EXPECT_NEAR(tile.y_at(4, 0), y, 1e-15);
  EXPECT_DOUBLE_EQ(tile.omega_at[1], 0.25);
  EXPECT_DOUBLE_EQ(tile.omega_at[4], 0.3);
}

TEST(RolloutRamp, DwaDrivesTheSampleFromTheStartButBrakesWithARamp) {
  Parameters p = coarse(Method::hidwa);
  p.acc_lim_x = 1.0;  // and brakes at it
  p.linear_granularity = 0.1;
  const Rollout rollout = run(p, {}, {0.4, 0.0}, {{{0.4, 0.0}, SampleKind::grid}, {{0.0, 0.0}, SampleKind::brake}});
  ASSERT_EQ(rollout.tile_count(), 2u);
  EXPECT_DOUBLE_EQ(rollout.tile(0).x_at(4, 0), 0.4);
  // 0.4 -> 0.15 -> 0 by 0.25 a step: means 0.275, 0.075, 0, 0 over 0.25 s each.
  EXPECT_DOUBLE_EQ(rollout.tile(1).x_at(4, 0), 0.25 * (0.275 + 0.075));
}

}  // namespace
}  // namespace hidwa_local_planner
