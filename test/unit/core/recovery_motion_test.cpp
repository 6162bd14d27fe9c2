// SPDX-License-Identifier: BSD-3-Clause
// When autonomy counts as stuck, told cycle by cycle how it fares.
#include "core/planner/recovery_motion.hpp"

#include <gtest/gtest.h>

#include "support/scene.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kPeriod = 0.05;   // [s]
constexpr double kPatience = 1.0;  // [s]

// How long a robot that stays where it is fares like that until recovery decides [s]; negative: longer than 20 s.
double until_it_decides(const RecoveryMotion::Course& course) {
  test::Scene scene = test::Scene::empty();
  const VelocityLimits limits = VelocityLimits::from(scene.parameters);
  const Footprint footprint = Footprint::from_outline(scene.outline, 0.0);
  const GridView grid = scene.grid();
  const OperatorIntent intent;
  const Sampling sampling;
  const CycleStart start;
  const Cycle cycle{scene.parameters, limits, footprint, grid, intent, sampling, scene.situation, start, nullptr, true};
  RecoveryMotion motion;
  for (int k = 0; k <= 400; ++k) {
    scene.situation.time = k * kPeriod;
    motion.watch(cycle, course, kPatience);
    if (motion.active()) return scene.situation.time;
  }
  return -1.0;
}

RecoveryMotion::Course fares(bool creeps, bool yields) {
  RecoveryMotion::Course course;
  course.autonomous = true;
  course.creeps = creeps;
  course.yields = yields;
  return course;
}

// 0.1 m at 0.5 m/s and 0.35 rad at 1 rad/s are 0.55 s, and three times that is 1.65 s: more than 1.5 s.
TEST(RecoveryMotion, WhoTurnsToAndFroIsStuck) {
  EXPECT_NEAR(until_it_decides(fares(false, false)), 1.65, 1.5 * kPeriod);
}

TEST(RecoveryMotion, WhoCreepsIsStuckOnceItIsOutOfPatience) {
  EXPECT_NEAR(until_it_decides(fares(true, false)), kPatience, 1.5 * kPeriod);
}

// What moves makes it turn to and fro, or creep for longer than its patience: that leads nowhere, and is right.
TEST(RecoveryMotion, WhoYieldsIsNotStuck) {
  EXPECT_LT(until_it_decides(fares(false, true)), 0.0);
  EXPECT_LT(until_it_decides(fares(true, true)), 0.0);
}

}  // namespace
}  // namespace hidwa_local_planner
