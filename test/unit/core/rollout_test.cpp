// SPDX-License-Identifier: BSD-3-Clause
// By hand; test/oracle/planner_twin_test.cpp compares the rollouts of random scenes.
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
  rollout.run(p, from, samples, {}, p.sim_time);
  return rollout;
}

TEST(RolloutSteps, Nav2sNumber) {
  Parameters p;
  p.method = Method::paper;
  p.angular_granularity = 0.025;
  p.sim_time = 1.7;
  const auto tile_of = [&p](const Twist2& u) { return run(p, {}, {}, {{u, SampleKind::grid}}).tile(0); };
  EXPECT_EQ(tile_of({0.5, 0.0}).steps, 17u);   // ceil(0.5 * 1.7 / 0.05)
  EXPECT_EQ(tile_of({0.5, -1.0}).steps, 68u);  // ceil(1 * 1.7 / 0.025)
  EXPECT_EQ(tile_of({0.0, 0.0}).steps, 1u);    // at least
  EXPECT_DOUBLE_EQ(tile_of({0.5, 0.0}).dt, 0.1);
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
