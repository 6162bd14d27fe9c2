// SPDX-License-Identifier: BSD-3-Clause
// Which candidates share a tile; test/oracle/planner_twin_test.cpp compares the rollouts of random scenes.
#include "core/motion/rollout.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

Rollout run(const Parameters& p, const std::vector<Sample>& samples) {
  Rollout rollout;
  CycleStart start;
  start.limits = VelocityLimits::from(p);
  rollout.run(p, start, samples, {}, p.sim_time);
  return rollout;
}

TEST(RolloutSteps, EulerCandidatesHaveTheirOwnMidpointOnesThoseOfTheFastest) {
  const std::vector<Sample> samples = {{{0.1, 0.2}, SampleKind::grid}, {{0.5, 0.2}, SampleKind::grid}};
  Parameters p;
  p.method = Method::paper;
  p.angular_granularity = 0.025;
  p.sim_time = 1.7;
  const Rollout euler = run(p, samples);
  ASSERT_EQ(euler.tile_count(), 2u);
  EXPECT_EQ(euler.tile(0).steps, 14u);  // ceil(0.2 * 1.7 / 0.025) = ceil(13.6)
  EXPECT_EQ(euler.tile(1).steps, 17u);
  p.method = Method::hidwa;
  const Rollout midpoint = run(p, samples);
  ASSERT_EQ(midpoint.tile_count(), 1u);
  EXPECT_EQ(midpoint.tile(0).steps, 17u);
  EXPECT_EQ(midpoint.tile(0).count, 2u);
}

}  // namespace
}  // namespace hidwa_local_planner
