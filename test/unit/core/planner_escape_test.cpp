// SPDX-License-Identifier: BSD-3-Clause
// A robot that already stands in collision.
#include <gtest/gtest.h>

#include "support/naive_collision.hpp"
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

TEST(Escape, ThePersonCannotPushItDeeper) {
  test::Random random(11);
  for (int scene_number = 0; scene_number < 25; ++scene_number) {
    Scene scene = against_the_wall();
    scene.situation.pose = {random.uniform(-0.1, 0.1), random.uniform(-0.3, 0.3), random.uniform(-3.0, 3.0)};
    scene.steer({0.5, random.uniform(-1.0, 1.0)});
    PlannerBench bench(scene);
    const int first = cells_under(bench.scene());
    int before = first;
    for (int k = 0; k < 40; ++k) {
      const bool chosen = bench.drive().outcome == Outcome::drive;
      const int now = cells_under(bench.scene());
      if (chosen) {
        ASSERT_LE(now, before) << scene_number;
      }
      // Where nothing is legal the robot brakes, and its last millimetres may touch one cell more.
      ASSERT_LE(now, first + 1) << scene_number;
      before = now;
    }
  }
}

TEST(Escape, OffThereIsNoWayOut) {
  Scene scene = against_the_wall();
  scene.parameters.escape = false;
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  EXPECT_EQ(decision.outcome, Outcome::fail);
  EXPECT_FALSE(decision.escaping);
  EXPECT_EQ(decision.legal, 0u);
}

TEST(Escape, WithoutReverseItTurnsOutOrSaysSo) {
  // Straight against the wall and no reverse: turning the square's corner goes deeper, driving too.
  Scene scene = against_the_wall();
  scene.parameters.min_vel_x = 0.0;
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  EXPECT_EQ(decision.outcome, Outcome::fail);
  EXPECT_FALSE(decision.problem.empty());
}

TEST(Escape, AStandingRobotInFreeSpaceIsNotEscaping) {
  Scene scene = against_the_wall();
  scene.situation.pose.x = -0.1;
  PlannerBench bench(scene);
  EXPECT_FALSE(bench.cycle().escaping);
}

}  // namespace
}  // namespace hidwa_local_planner
