// SPDX-License-Identifier: BSD-3-Clause
// Autonomy turns gently where it can choose; the operator, braking and what must be do not wait for it.
#include "core/motion/comfort_turn.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/planner_bench.hpp"

namespace hidwa_local_planner {
namespace {

using test::PlannerBench;
using test::Scene;

constexpr double kPeriod = 0.05;  // [s]
const AxisLimits kAxis{-1.0, 1.0, 3.2, 2.0};

TEST(ComfortTurn, IsReachedEvenlyAndNoFasterThanTheLimit) {
  const ComfortTurn comfort{0.8, 0.5};
  EXPECT_DOUBLE_EQ(comfort.towards(kAxis, 0.2, 0.5).acc, 0.6);      // 0.3 rad/s in 0.5 s
  EXPECT_DOUBLE_EQ(comfort.towards(kAxis, 0.5, 0.2).braking, 0.6);  // slowing down too
  EXPECT_DOUBLE_EQ(comfort.towards(kAxis, 0.2, -0.9).acc, 0.8);     // 1.1 rad/s would take 2.2 rad/s^2
  EXPECT_DOUBLE_EQ(comfort.widest(kAxis, 0.2).acc, 0.8);
  EXPECT_DOUBLE_EQ((ComfortTurn{0.8, 0.0}.towards(kAxis, 0.2, 0.3).acc), 0.8);
}

TEST(ComfortTurn, NeverExceedsTheRobotsOwnLimits) {
  const ComfortTurn comfort{2.5, 0.0};
  EXPECT_DOUBLE_EQ(comfort.towards(kAxis, 0.0, 1.0).acc, 2.5);
  EXPECT_DOUBLE_EQ(comfort.towards(kAxis, 0.0, 1.0).braking, 2.0);
}

TEST(ComfortTurn, DoesNotBindWhatIsFasterThanTheRobotMayTurn) {
  const ComfortTurn comfort{0.8, 0.5};
  EXPECT_DOUBLE_EQ(comfort.towards(kAxis, 1.1, 0.9).braking, 2.0);
  EXPECT_DOUBLE_EQ(comfort.widest(kAxis, -1.1).braking, 2.0);
}

TEST(ComfortTurn, TakesRampsAndFeasibleCommands) {
  Parameters p;
  EXPECT_TRUE(ComfortTurn::from(p).binds());
  p.generator = Generator::dwa;
  EXPECT_FALSE(ComfortTurn::from(p).binds());
  p = Parameters();
  p.method = Method::paper;  // commands are feasible while braking is checked
  EXPECT_TRUE(ComfortTurn::from(p).binds());
  p.admissibility = Admissibility::horizon;
  EXPECT_FALSE(ComfortTurn::from(p).binds());
  p = Parameters();
  p.comfort_acc_lim_theta = 0.0;
  EXPECT_FALSE(ComfortTurn::from(p).binds());
}

// The robot drives off the plan, 0.5 m to its right and along it: it has to turn left.
Scene beside_the_plan() {
  Scene scene = Scene::empty(121);
  scene.situation.pose = {0.0, -0.5, 0.0};
  scene.situation.velocity = scene.situation.last_command = {0.5, 0.0};
  return scene;
}

TEST(GentleAutonomy, TurnsWithinItsComfortAllTheWayBackToThePlan) {
  PlannerBench bench(beside_the_plan());
  double before = 0.0, hardest = 0.0;
  for (int k = 0; k < 60; ++k) {
    const double omega = bench.drive().command.omega;
    hardest = std::max(hardest, std::abs(omega - before) / kPeriod);
    before = omega;
  }
  EXPECT_LE(hardest, 0.8 + 1e-9);
  EXPECT_GT(hardest, 0.2);                          // it did turn
  EXPECT_GT(bench.scene().situation.pose.y, -0.4);  // towards the plan
}

TEST(GentleAutonomy, SwitchedOffItTurnsAtTheLimit) {
  Scene scene = beside_the_plan();
  scene.parameters.comfort_acc_lim_theta = 0.0;
  PlannerBench bench(scene);
  EXPECT_NEAR(bench.cycle().command.omega, 3.2 * kPeriod, 1e-9);
}

TEST(GentleAutonomy, DoesNotBindTheOperator) {
  Scene scene = beside_the_plan();
  scene.steer({0.5, -1.0});
  PlannerBench bench(scene);
  EXPECT_NEAR(bench.cycle().command.omega, -3.2 * kPeriod, 1e-9);
}

TEST(GentleAutonomy, AfterAReleaseItBendsBack) {
  Scene scene = beside_the_plan();
  scene.situation.velocity = scene.situation.last_command = {0.5, -0.8};  // steered away from the plan
  PlannerBench bench(scene);
  const double omega = bench.cycle().command.omega;
  EXPECT_GT(omega, -0.8);
  EXPECT_LE(omega, -0.8 + 0.8 * kPeriod + 1e-9);
}

TEST(GentleAutonomy, GivesWayWhereOnlyRestIsLeft) {
  // A wall 0.45 m ahead: the front reaches 0.2 m, and braking from 0.5 m/s at 2.5 m/s^2 takes 0.05 m, with a latency of
  // 0.1 s and a period of 0.05 s 0.125 m. Turning at 0.8 rad/s no candidate gets round it.
  Scene scene = Scene::empty(121);
  scene.situation.velocity = scene.situation.last_command = {0.5, 0.6};
  scene.fill(0.35, -3.0, 0.5, 3.0);
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  EXPECT_EQ(decision.outcome, Outcome::drive);
  if (decision.sample == Twist2{}) {  // it brakes as hard as it can, the turn too
    EXPECT_NEAR(decision.command.v, 0.5 - 2.5 * kPeriod, 1e-9);
    EXPECT_NEAR(decision.command.omega, 0.6 - 3.2 * kPeriod, 1e-9);
  }
  // Whatever it chooses, it comes to rest before the wall.
  for (int k = 0; k < 40; ++k) bench.drive();
  EXPECT_LT(bench.scene().situation.pose.x, 0.15);
}

TEST(GentleAutonomy, TheLastTurnEndsInARamp) {
  Scene scene = Scene::empty(121);
  scene.situation.goal = {0.0, 0.0, 1.5};
  scene.situation.plan = {{-0.05, 0.0, 0.0}, {0.0, 0.0, 1.5}};
  scene.situation.goal_latched = true;
  PlannerBench bench(scene);
  double before = 0.0, hardest = 0.0, farthest = 0.0;
  for (int k = 0; k < 100; ++k) {
    const double omega = bench.drive().command.omega;
    hardest = std::max(hardest, std::abs(omega - before) / kPeriod);
    before = omega;
    farthest = std::max(farthest, bench.scene().situation.pose.theta);
  }
  EXPECT_LE(hardest, 0.8 + 1e-9);
  EXPECT_NEAR(bench.scene().situation.pose.theta, 1.5, 0.1);
  EXPECT_LT(farthest, 1.6);  // it does not turn past the heading and back
}

}  // namespace
}  // namespace hidwa_local_planner
