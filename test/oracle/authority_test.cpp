// SPDX-License-Identifier: BSD-3-Clause
// Authority blends the reference, on the oracle scene of the paper's profile (PaperScene) and in front of an obstacle.
#include <cmath>

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/naive_collision.hpp"
#include "support/paper_scene.hpp"
#include "support/planner_bench.hpp"
#include "support/renewed_planner.hpp"

namespace hidwa_local_planner::test {
namespace {

constexpr double kSpeed = 0.26;  // v_max of the paper's profile [m/s]
constexpr int kSteps = 100;      // of a

Decision decide(const PaperScene& scene, double authority, const OperatorIntent& intent) {
  Parameters p = paper_parameters();
  p.authority = authority;
  Planner planner(critics::built_in());
  EXPECT_TRUE(planner.configure(p).empty());
  planner.set_footprint(scene.outline);
  return planner.plan(scene.situation, scene.grid, intent);
}

OperatorIntent steering(double omega_h) {
  OperatorIntent intent;
  intent.state = OperatorStateId::shared;
  intent.influence = Influence::shared;
  intent.u_h = {kSpeed, omega_h};
  return intent;
}

class AuthorityOn : public ::testing::TestWithParam<double> {};

TEST_P(AuthorityOn, ThePapersScene) {
  const PaperScene scene(kSpeed);
  const Parameters p = paper_parameters();
  // The window of the standard generator holds all velocities here: 20 samples over [-1, 1] rad/s and [0, 0.26] m/s.
  const double omega_spacing = 2.0 / (p.vth_samples - 1);
  const double v_spacing = kSpeed / (p.vx_samples - 1);
  const OperatorIntent wanted = steering(GetParam());
  const Decision alone = decide(scene, 1.0, OperatorIntent());
  const Decision paper = decide(scene, 1.0, wanted);
  const Twist2 u_nv = alone.sample;
  double before = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double a = static_cast<double>(i) / kSteps;
    const Decision decision = decide(scene, a, wanted);
    const Twist2 u = decision.sample;
    if (i == 0) {
      EXPECT_TRUE(u == alone.sample);
      EXPECT_TRUE(decision.command == alone.command);
    } else {
      // One step of a moves u_ref by so much; u* by at most one spacing more.
      const double asked = std::abs(wanted.u_h.omega - u_nv.omega) / kSteps;
      EXPECT_GE(u.omega, before - 1e-12) << a;
      EXPECT_LE(u.omega - before, asked + omega_spacing + 1e-12) << a;
    }
    EXPECT_GE(u.v, std::min(u_nv.v, kSpeed) - v_spacing - 1e-12) << a;
    before = u.omega;
    if (i == kSteps) {
      EXPECT_TRUE(u == paper.sample);
      EXPECT_TRUE(decision.command == paper.command);
      EXPECT_EQ(decision.total, paper.total);
    }
  }
  EXPECT_GT(before, u_nv.omega);
}

INSTANTIATE_TEST_SUITE_P(OmegaOfThePerson, AuthorityOn, ::testing::Values(0.05, 0.1, 0.25, 0.5, 1.0));

// Halfway between autonomy's straight on and the person's turn: the blend itself is tried, whatever the grid.
TEST(Authority, TheBlendIsACandidate) {
  Scene scene = Scene::empty(121);
  scene.situation.velocity = scene.situation.last_command = {0.5, 0.0};
  scene.parameters.authority = 0.5;
  scene.steer({0.5, 0.6137});
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  // Straight on is autonomy's choice on a straight plan: u_ref = 0.5 (0.5, 0) + 0.5 (0.5, 0.6137).
  EXPECT_DOUBLE_EQ(decision.sample.v, 0.5);
  EXPECT_DOUBLE_EQ(decision.sample.omega, 0.30685);  // grid samples lie 2 / 19 = 0.105 rad/s apart
  // Half a span from the wish: 1 - |0.6137 - 0.30685| / 2, measured against u_h and not against the blend.
  EXPECT_DOUBLE_EQ(decision.agreement, 1.0 - 0.30685 / 2.0);
}

// A wall on the left, where the person pushes: whatever the authority, the chosen rollout is free.
TEST(Authority, InFrontOfAnObstacleTheChoiceStaysLegal) {
  Scene scene = Scene::empty(121);
  scene.fill(0.4, 0.25, 3.0, 3.0);
  scene.situation.velocity = scene.situation.last_command = {0.5, 0.0};
  const NaiveBody body{scene.outline, 0.0};
  RenewedPlanner renewed;
  for (const double omega_h : {0.05, 0.1, 0.25, 0.5, 1.0}) {
    for (int i = 0; i <= kSteps; ++i) {
      scene.parameters.authority = static_cast<double>(i) / kSteps;
      scene.steer({0.5, omega_h});
      const Decision decision = renewed(scene).plan(scene.situation, scene.grid(), scene.intent);
      ASSERT_EQ(decision.outcome, Outcome::drive) << omega_h << " " << i;
      for (const Pose2& pose : decision.trajectory) {
        ASSERT_LT(naive_overlap(scene.grid(), body, pose, true), 1e-9) << omega_h << " " << i;
      }
    }
  }
}

// Nothing to add to autonomy, nothing to take away: also what it forbids, such as turning back and forth.
TEST(Authority, NoneIsAutonomyThroughoutADrive) {
  Scene scene = Scene::empty(121);
  for (Pose2& pose : scene.situation.plan) pose = {pose.x, 0.4 * std::sin(2.0 * pose.x), 0.0};
  Scene steered = scene;
  steered.parameters.authority = 0.0;
  steered.steer({0.5, -1.0});
  PlannerBench alone(scene), with_person(steered);
  for (int k = 0; k < 40; ++k) {
    const Decision &one = alone.drive(), &two = with_person.drive();
    ASSERT_TRUE(one.command == two.command) << k;
    ASSERT_EQ(one.outcome, two.outcome);
  }
}

}  // namespace
}  // namespace hidwa_local_planner::test
