// SPDX-License-Identifier: BSD-3-Clause
// A robot that already stands in collision.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "support/naive_escape.hpp"
#include "support/planner_bench.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

using test::PlannerBench;
using test::Scene;

int cells_under(const Scene& scene) {
  int cells = 0;
  test::naive_overlap(scene.grid(), {scene.outline, 0.0}, scene.situation.pose, true, &cells);
  return cells;
}

// The square of 0.4 m stands 0.03 m deep in a wall ahead of it; it can reverse.
Scene against_the_wall() {
  Scene scene = Scene::empty(81);
  scene.fill(0.15, -9.0, 9.0, 9.0);  // cells from x = 0.175 on
  scene.situation.pose = {0.005, 0.013, 0.0};
  scene.parameters.min_vel_x = -0.2;
  scene.parameters.control_latency = 0.0;  // commands take effect at once here
  for (Pose2& pose : scene.situation.plan) pose = {-0.6 - 0.05 * pose.x, 0.0, 0.0};
  return scene;
}

TEST(Escape, GetsOutAndNeverDeeper) {
  PlannerBench bench(against_the_wall());
  int before = cells_under(bench.scene());
  ASSERT_GT(before, 0);
  bool escaping = true;
  for (int k = 0; k < 100 && before > 0; ++k) {
    const Decision& decision = bench.drive();
    escaping = decision.escaping;
    ASSERT_TRUE(escaping);
    ASSERT_EQ(decision.outcome, Outcome::drive);
    const int now = cells_under(bench.scene());
    ASSERT_LE(now, before);
    before = now;
  }
  EXPECT_EQ(before, 0);
  EXPECT_FALSE(bench.cycle().escaping);
}

test::NaiveEscape contact(const Scene& scene) {
  constexpr int kSteps = 8;  // as far as it may get [cells]
  return {scene.grid(), {scene.outline, 0.0}, true, scene.situation.pose, kSteps};
}

// The bench reaches every command evenly, braking included, which the planner expects at the limits: that is where the
// 0.2 mm come from.
TEST(Escape, ThePersonCannotPushItDeeper) {
  test::Random random(11);
  for (int scene_number = 0; scene_number < 25; ++scene_number) {
    Scene scene = against_the_wall();
    scene.situation.pose = {random.uniform(-0.1, 0.1), random.uniform(-0.3, 0.3), random.uniform(-3.0, 3.0)};
    scene.steer({0.5, random.uniform(-1.0, 1.0)});
    PlannerBench bench(scene);
    for (int k = 0; k < 40; ++k) {
      const test::NaiveEscape before = contact(bench.scene());
      bench.drive();
      const Pose2 now = bench.scene().situation.pose;
      ASSERT_LE(before.total(now), before.start_total() + 2e-4) << scene_number;
      ASSERT_LE(before.excess(now, true), 2e-4) << scene_number;
    }
  }
}

// The samples are spread over what is slow enough.
TEST(Escape, ThereAreManySlowCandidates) {
  Scene scene = Scene::empty(81);
  scene.parameters = Parameters();
  scene.at({36, 40}) = cost::kLethal;  // up to x = -0.175: 25 mm in its rear
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  EXPECT_TRUE(decision.escaping);
  EXPECT_GE(decision.candidates, 2400u);
  EXPECT_GE(decision.legal, 300u);
  EXPECT_GT(decision.sample.v, 0.1);
  EXPECT_LE(decision.sample.v, 0.1404);  // 0.15 v + v^2 / 5 = 0.025
}

TEST(Escape, ThePapersMethodHasNoWayOut) {
  Scene scene = against_the_wall();
  scene.parameters.method = Method::paper;
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  EXPECT_EQ(decision.outcome, Outcome::fail);
  EXPECT_FALSE(decision.escaping);
  EXPECT_EQ(decision.legal, 0u);
}

// Straight against the wall and no reverse: turning the square's corner goes deeper, driving too. It waits for a new
// scan to take the wall away, and after 1 s it says so.
TEST(Escape, WithoutAWayOutItFailsAfterASecond) {
  for (const bool steered : {false, true}) {
    Scene scene = against_the_wall();
    scene.parameters.min_vel_x = 0.0;
    if (steered) scene.steer({0.5, 0.0});
    PlannerBench bench(scene);
    for (int k = 0; k < 30; ++k) {
      const Decision& decision = bench.drive();
      const bool says_so = decision.problem.find("no way out") != std::string::npos;
      EXPECT_EQ(decision.outcome == Outcome::fail, k >= 20) << k;  // 20 periods of 0.05 s
      EXPECT_EQ(says_so, k >= 20) << k;
      EXPECT_TRUE(decision.command == Twist2{});
    }
    // The host clears: nothing is left of it.
    for (std::uint8_t& cost : bench.scene().costs) cost = cost::kFree;
    EXPECT_EQ(bench.drive().outcome, Outcome::drive);
  }
}

// With one rate of turn the fastest reverse is the first of all candidates: number 0 is a candidate like any other.
TEST(Escape, WhoDrivesOutIsNotTrapped) {
  Scene scene = against_the_wall();
  scene.parameters.max_vel_theta = 0.0;
  scene.parameters.min_vel_x = -0.05;  // at most 0.1 m to drive: 2 s
  scene.parameters.stall_time = 0.2;   // who is trapped for half of it, two periods, begins a turn
  PlannerBench bench(scene);
  int cycles = 0;
  for (; cycles < 40 && cells_under(bench.scene()) > 0; ++cycles) {
    const Decision& decision = bench.drive();
    ASSERT_EQ(decision.outcome, Outcome::drive) << cycles;
    EXPECT_TRUE(decision.sample == (Twist2{-0.05, 0.0})) << cycles;
    EXPECT_FALSE(decision.recovering) << cycles;
  }
  EXPECT_EQ(cells_under(bench.scene()), 0);
  EXPECT_GT(cycles, 10);
}

// It is steered and cannot move at all: rest is number 0, and legal, but nothing leads out.
TEST(Escape, WhoHasOnlyRestLeftIsTrapped) {
  Scene scene = against_the_wall();
  scene.parameters.min_vel_x = scene.parameters.max_vel_x = scene.parameters.max_vel_theta = 0.0;
  scene.steer({0.5, 0.0});
  PlannerBench bench(scene);
  for (int k = 0; k < 30; ++k) EXPECT_EQ(bench.drive().outcome == Outcome::fail, k >= 20) << k;  // after a second
}

// Nobody drives it away from where a person has it stand.
TEST(Escape, APersonMayHaveItStand) {
  Scene scene = against_the_wall();
  scene.steer({0.0, 0.0});
  scene.intent.influence = Influence::direct;
  PlannerBench bench(scene);
  for (int k = 0; k < 30; ++k) EXPECT_EQ(bench.drive().outcome, Outcome::hold);
}

// A scan puts a cell into its side while it drives 0.5 m/s: it brakes to what stops within half a cell, and drives on.
TEST(Escape, WhoIsFasterBrakesAndDrivesOn) {
  Scene scene = Scene::empty(121);
  scene.parameters.control_latency = 0.0;
  scene.situation.velocity = scene.situation.last_command = {0.5, 0.0};
  scene.at({62, 64}) = cost::kLethal;  // from y = 0.175 on, 25 mm deep beside its front half
  PlannerBench bench(scene);
  double v = 0.5;
  for (int k = 0; k < 40; ++k) {
    const Decision& decision = bench.drive();
    if (!decision.escaping) continue;
    ASSERT_EQ(decision.outcome, Outcome::drive) << k;
    // 2.5 * 0.05 slower each time, until 0.05 v + v^2 / 5 = 0.025: v = 0.25 m/s.
    EXPECT_LE(decision.command.v, std::max(v - 0.125, 0.25) + 1e-9) << k;
    v = decision.command.v;
  }
  EXPECT_GT(bench.scene().situation.pose.x, 0.4);
  EXPECT_FALSE(bench.cycle().escaping);
}

// A corridor whose left wall a scan has moved 4 mm into it: along it and out where it ends, forward.
TEST(Escape, AlongAGrazedWallInACorridor) {
  Scene scene = Scene::empty(121);
  scene.parameters.control_latency = 0.0;
  scene.situation.pose = {-1.0, 0.029, 0.0};  // its side at 0.229
  scene.fill(-9.0, 0.2, 0.3, 0.4);            // from y = 0.225 on
  scene.fill(-9.0, -0.4, 9.0, -0.3);          // up to y = -0.275
  PlannerBench bench(scene);
  bool grazed = false;
  for (int k = 0; k < 400 && bench.scene().situation.pose.x < 0.8; ++k) {
    const test::NaiveEscape before = contact(bench.scene());
    grazed = grazed || before.overlaps();
    bench.drive();
    const Pose2 now = bench.scene().situation.pose;
    ASSERT_LE(before.total(now), before.start_total() + 1e-4) << k;
    ASSERT_LE(before.excess(now, true), 1e-4) << k;
  }
  EXPECT_TRUE(grazed);
  EXPECT_GE(bench.scene().situation.pose.x, 0.8);
}

}  // namespace
}  // namespace hidwa_local_planner
