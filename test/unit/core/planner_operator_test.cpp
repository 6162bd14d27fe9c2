// SPDX-License-Identifier: BSD-3-Clause
// The person and the planner.
#include <gtest/gtest.h>

#include "support/naive_collision.hpp"
#include "support/planner_bench.hpp"

namespace hidwa_local_planner {
namespace {

using test::PlannerBench;
using test::Scene;

Scene driving(double v = 0.5) {
  Scene scene = Scene::empty(121);
  scene.situation.velocity = scene.situation.last_command = {v, 0.0};
  return scene;
}

// By an operator who decides alone.
void take_over(Scene& scene, const Twist2& wanted) {
  scene.intent.state = OperatorStateId::manual;
  scene.intent.influence = Influence::direct;
  scene.intent.u_h = wanted;
}

double overlap(PlannerBench& bench) {
  const Scene& scene = bench.scene();
  return test::naive_overlap(scene.grid(), {scene.outline, 0.0}, scene.situation.pose, true);
}

TEST(Shared, ThePapersWeightsFollowThePerson) {
  for (const double omega : {0.07, -0.4, 1.0}) {
    Scene scene = driving();
    scene.steer({0.5, omega});
    PlannerBench bench(scene);
    const Decision& decision = bench.cycle();
    EXPECT_TRUE(decision.sample == (Twist2{0.5, omega}));
    EXPECT_EQ(decision.agreement, 1.0);
    EXPECT_TRUE(decision.operator_rejected_by.empty());
    EXPECT_NEAR(decision.command.omega, std::copysign(std::min(0.16, std::abs(omega)), omega), 1e-12);
  }
}

// A wall across the way, 1 m ahead of the robot's front; the person pushes straight on.
TEST(Shared, InFrontOfAWallItStopsAndDoesNotTurnAway) {
  Scene scene = driving();
  scene.fill(1.2, -9.0, 9.0, 9.0);  // cells from x = 1.225 on, the front starts at 0.2
  scene.steer({0.5, 0.0});
  PlannerBench bench(scene);
  std::string rejected_by;
  for (int k = 0; k < 200; ++k) {
    const Decision& decision = bench.drive();
    ASSERT_NE(decision.outcome, Outcome::fail);
    ASSERT_LT(overlap(bench), 1e-9);
    // Beyond v_max / 2 = 0.25 rad/s a turn costs more than stopping: 800 * 0.25 = 400 * 0.5.
    ASSERT_LE(std::abs(decision.sample.omega), 0.25);
    rejected_by = decision.operator_rejected_by;
  }
  EXPECT_TRUE(bench.scene().situation.last_command == Twist2{});
  EXPECT_EQ(rejected_by, "Collision");
  EXPECT_LT(bench.cycle().agreement, 0.5);
  EXPECT_GT(bench.scene().situation.pose.x, 0.5);  // it did approach
}

TEST(Shared, HeldAtRestItIsNoFailureAndAutonomyStartsAfresh) {
  Scene scene = driving(0.0);
  scene.fill(0.25, -9.0, 9.0, 9.0);
  scene.steer({0.5, 0.0});
  PlannerBench bench(scene);
  for (int k = 0; k < 60; ++k) ASSERT_NE(bench.drive().outcome, Outcome::fail);  // 3 s against the wall
  bench.scene().intent = OperatorIntent();
  EXPECT_NE(bench.drive().outcome, Outcome::fail);  // not stuck since 3 s: autonomy has only just begun
}

TEST(Direct, GuardedTakesTheNearestLegalControl) {
  Scene scene = driving();
  take_over(scene, {0.2, 0.7});
  PlannerBench free(scene);
  const Decision& decision = free.cycle();
  EXPECT_TRUE(decision.sample == (Twist2{0.2, 0.7}));
  EXPECT_EQ(decision.total, 0.0);  // the deviation alone

  scene.fill(1.2, -9.0, 9.0, 9.0);
  scene.intent.u_h = {0.5, 0.0};
  PlannerBench wall(scene);
  for (int k = 0; k < 200; ++k) {
    wall.drive();
    ASSERT_LT(overlap(wall), 1e-9);
  }
  EXPECT_NEAR(wall.scene().situation.last_command.v, 0.0, 0.05);
}

// At the goal's position, with the critics and samples of the default parameters.
TEST(Direct, AtTheGoalNoCriticRejectsThePerson) {
  for (const double v : {0.0, 0.3}) {
    for (const Twist2& wanted : {Twist2{0.5, 0.0}, Twist2{0.4, -0.8}}) {
      Scene scene = driving(v);
      scene.parameters = Parameters();
      scene.situation.goal = {0.1, 0.0, 1.0};
      scene.situation.goal_latched = true;
      take_over(scene, wanted);
      PlannerBench bench(scene);
      const Decision& decision = bench.cycle();
      EXPECT_EQ(test::rejections_by(decision, "RotateToGoal"), 0u);
      EXPECT_EQ(decision.legal, decision.candidates);
      EXPECT_TRUE(decision.sample == wanted) << decision.sample.v << " " << decision.sample.omega;
      EXPECT_TRUE(decision.operator_rejected_by.empty()) << decision.operator_rejected_by;
    }
  }
}

// The paper's method has no sample of its own for the operator command: 20 of them, from -1 to 1 rad/s, lie 2/19 rad/s
// apart, more of them nearer.
double off_the_wanted_turn(Method method) { return method == Method::paper ? 1.0 / 19.0 : 0.0; }

// Back and forth on the spot, as long as the person wants it, whatever the method.
TEST(Direct, ThePersonMayGoBackAndForth) {
  for (const Method method : {Method::hidwa, Method::paper}) {
    Scene scene = driving(0.0);
    scene.parameters.method = method;
    PlannerBench bench(scene);
    for (int k = 0; k < 12; ++k) {
      const double wanted = k % 2 == 0 ? 0.1 : -0.1;
      take_over(bench.scene(), {0.0, wanted});
      const Decision& decision = bench.drive();
      EXPECT_EQ(test::rejections_by(decision, "Oscillation"), 0u) << k;
      EXPECT_EQ(decision.sample.v, 0.0) << k;
      EXPECT_NEAR(decision.sample.omega, wanted, off_the_wanted_turn(method)) << k;
    }
  }
}

TEST(Direct, UnguardedPassesWithinLimitsAndAccelerations) {
  Scene scene = driving(0.3);
  scene.fill(0.3, -9.0, 9.0, 9.0);
  take_over(scene, {9.0, -9.0});
  scene.intent.guarded = false;
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  EXPECT_EQ(decision.outcome, Outcome::drive);
  EXPECT_TRUE(decision.sample == (Twist2{0.5, -1.0}));
  EXPECT_NEAR(decision.command.v, 0.425, 1e-12);      // 0.3 + 2.5 * 0.05
  EXPECT_NEAR(decision.command.omega, -0.16, 1e-12);  // 3.2 * 0.05
  scene.intent.u_h = {};
  scene.situation.velocity = scene.situation.last_command = {};
  PlannerBench idle(scene);
  EXPECT_EQ(idle.cycle().outcome, Outcome::hold);
}

TEST(PlanOutsideTheMap, ASteeredRobotGoesOnAutonomyDoesNot) {
  Scene scene = driving();
  for (Pose2& pose : scene.situation.plan) pose.x += 100.0;
  scene.situation.goal.x += 100.0;
  PlannerBench autonomy(scene);
  const Decision& alone = autonomy.cycle();
  EXPECT_EQ(alone.outcome, Outcome::brake);
  EXPECT_NE(alone.problem.find("plan"), std::string::npos);
  scene.steer({0.5, 0.6});
  PlannerBench steered(scene);
  const Decision& decision = steered.cycle();
  EXPECT_EQ(decision.outcome, Outcome::drive);
  EXPECT_TRUE(decision.sample == (Twist2{0.5, 0.6}));
}

TEST(Stuck, AutonomyThatPrefersStandingStillFailsAfterAWhile) {
  Scene scene = driving(0.0);
  scene.situation.plan = {{0.0, 0.0, 0.0}};  // nowhere to go, but the goal is not here
  scene.situation.goal = {3.0, 0.0, 0.0};
  PlannerBench bench(scene);
  double failed_at = -1.0;
  for (int k = 0; k < 60 && failed_at < 0.0; ++k) {
    const double now = bench.scene().situation.time;
    const Decision& decision = bench.drive();
    if (decision.outcome == Outcome::fail) {
      failed_at = now;
      EXPECT_NE(decision.problem.find("stuck"), std::string::npos);
    } else {
      EXPECT_EQ(decision.outcome, Outcome::hold);
    }
  }
  // More than stall_time (1 s) after the first cycle at rest, in cycles of 0.05 s.
  EXPECT_GT(failed_at, 1.0 - 1e-9);
  EXPECT_LT(failed_at, 1.1 + 1e-9);
}

TEST(Stuck, AtTheGoalStandingStillIsNoFailure) {
  Scene scene = driving(0.0);
  scene.situation.plan = {{0.0, 0.0, 0.0}};
  scene.situation.goal = {0.0, 0.0, 0.0};
  scene.situation.goal_latched = true;
  PlannerBench bench(scene);
  for (int k = 0; k < 60; ++k) EXPECT_EQ(bench.drive().outcome, Outcome::hold);
}

// The person had the robot turn left and right, so that Oscillation forbids the turn that is left to do at the goal.
TEST(Stuck, AForbiddenLastTurnIsMadeAllTheSame) {
  for (const double side : {1.0, -1.0}) {
    Scene scene = driving(0.0);
    scene.parameters.method = Method::paper;
    scene.situation.plan = {{0.0, 0.0, 0.0}};
    scene.situation.goal = {0.0, 0.0, side * 1.5};
    scene.situation.goal_latched = true;
    scene.parameters.s_omega = 1e4;
    PlannerBench bench(scene);
    // A turn the right way and one back: from then on the right way is forbidden.
    for (const double omega : {0.16, -0.16}) {
      bench.scene().steer({0.0, side * omega});
      bench.drive();
    }
    bench.scene().intent = OperatorIntent();
    bench.scene().situation.velocity = bench.scene().situation.last_command = {};
    int stood = 0;
    for (int k = 0; k < 120; ++k) {
      const Decision& decision = bench.drive();
      ASSERT_NE(decision.outcome, Outcome::fail);
      if (decision.outcome == Outcome::hold && k < 20) ++stood;
    }
    EXPECT_GE(stood, 5);  // or nothing was forbidden
    EXPECT_NEAR(bench.scene().situation.pose.theta, side * 1.5, 0.25);
  }
}

}  // namespace
}  // namespace hidwa_local_planner
