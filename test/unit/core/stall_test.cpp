// SPDX-License-Identifier: BSD-3-Clause
// When autonomy counts as stuck, told cycle by cycle what is driven.
#include <gtest/gtest.h>

#include "core/autonomy/autonomy.hpp"
#include "core/autonomy/novelty.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kPeriod = 0.05;   // [s]
constexpr double kPatience = 1.0;  // [s], half of stall_time

// How long a robot that stays where it is drives like that until recovery decides [s]; negative: longer than 20 s.
double until_it_decides(const Twist2& u, bool yields) {
  test::Scene scene = test::Scene::empty();
  scene.parameters.stall_time = 2.0 * kPatience;
  const Footprint footprint = Footprint::from_outline(scene.outline, 0.0);
  const GridView grid = scene.grid();
  const OperatorIntent intent;
  const Sampling sampling;
  CycleStart start;
  start.limits = VelocityLimits::from(scene.parameters);
  const BlindMotion all_round;
  const Cycle cycle{scene.parameters, footprint, grid,      intent,  sampling,
                    scene.situation,  start,     all_round, nullptr, true};
  Autonomy::Driven driven;
  driven.steps.asked = true;
  driven.conclusion = follow(u, u);
  driven.yields = yields;
  Autonomy autonomy;
  for (int k = 0; k <= 400; ++k) {
    scene.situation.time = k * kPeriod;
    autonomy.commit(cycle, {}, driven);
    if (autonomy.active()) return scene.situation.time;
  }
  return -1.0;
}

constexpr Twist2 kDrives{0.3, 0.0}, kCreeps{0.0, 0.1};

// 0.1 m at 0.5 m/s and 0.35 rad at 1 rad/s are 0.55 s, and three times that is 1.65 s: more than 1.5 s.
TEST(Stall, WhoTurnsToAndFroIsStuck) { EXPECT_NEAR(until_it_decides(kDrives, false), 1.65, 1.5 * kPeriod); }

TEST(Stall, WhoCreepsIsStuckOnceItIsOutOfPatience) {
  EXPECT_NEAR(until_it_decides(kCreeps, false), kPatience, 1.5 * kPeriod);
}

// What moves makes it turn to and fro, or creep for longer than its patience: that leads nowhere, and is right.
TEST(Stall, WhoYieldsIsNotStuck) {
  EXPECT_LT(until_it_decides(kDrives, true), 0.0);
  EXPECT_LT(until_it_decides(kCreeps, true), 0.0);
}

// Eight poses 0.2 m apart fill its memory, and three more begin anew in it. After a reset only the next pose is known.
TEST(Novelty, AResetForgetsEveryPose) {
  Novelty novelty;
  double now = 0.0;
  for (int k = 0; k < 11; ++k) novelty.observe({0.2 * k, 0.0, 0.0}, now += 1.0);
  novelty.reset();
  novelty.observe({5.0, 0.0, 0.0}, now += 1.0);
  novelty.observe({5.0, 0.0, 0.0}, now += 1.0);
  EXPECT_DOUBLE_EQ(novelty.time_without(now), 1.0);
  novelty.observe({0.0, 0.0, 0.0}, now += 1.0);  // forgotten, so it is new
  EXPECT_DOUBLE_EQ(novelty.time_without(now), 0.0);
}

}  // namespace
}  // namespace hidwa_local_planner
