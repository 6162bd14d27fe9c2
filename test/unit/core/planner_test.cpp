// SPDX-License-Identifier: BSD-3-Clause
// The whole cycle: cost, outcomes, explanations. The default robot: 0.5 m/s, 1 rad/s, 2.5 m/s^2, 3.2 rad/s^2,
// a square of 0.4 m, cycles of 0.05 s.
#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/planner_bench.hpp"

namespace hidwa_local_planner {
namespace {

using test::PlannerBench;
using test::rejections_by;
using test::Scene;

Scene driving(double v = 0.5) {
  Scene scene = Scene::empty(81);
  scene.situation.velocity = scene.situation.last_command = {v, 0.0};
  return scene;
}

TEST(PlannerCycle, DrivesAlongAFreePlan) {
  PlannerBench bench(driving());
  const Decision& decision = bench.cycle();
  EXPECT_EQ(decision.outcome, Outcome::drive);
  EXPECT_TRUE(decision.command == (Twist2{0.5, 0.0}));
  EXPECT_TRUE(decision.rejections.empty());
  EXPECT_EQ(decision.legal, decision.candidates);
  EXPECT_EQ(decision.candidates, 421u);  // 419, stopping, the last command
  EXPECT_TRUE(decision.problem.empty());
  EXPECT_NEAR(decision.trajectory.back().x, 0.85, 1e-9);  // 0.5 * 1.7
  EXPECT_NEAR(decision.step * static_cast<double>(decision.trajectory.size() - 1), 1.7, 1e-9);
}

TEST(PlannerCycle, TheCommandIsTheFirstFeasibleStep) {
  PlannerBench bench(driving(0.0));
  const Decision& decision = bench.cycle();
  EXPECT_DOUBLE_EQ(decision.command.v, 0.125);  // 2.5 * 0.05
  EXPECT_EQ(decision.sample.v, 0.5);
  Scene scene = driving(0.0);
  scene.parameters.method = Method::paper;
  PlannerBench checked(scene);
  EXPECT_EQ(checked.cycle().command.v, 0.125);  // with the check for braking it is feasible all the same
  scene.parameters.admissibility = Admissibility::horizon;
  PlannerBench target(scene);
  EXPECT_EQ(target.cycle().command.v, 0.5);
}

TEST(PlannerCost, TheTotalIsTheSumOfItsTerms) {
  Scene scene = driving();
  scene.situation.pose.y = 0.3;
  scene.steer({0.5, 0.4});
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  double sum = 0.0;
  for (const CriticTerm& term : decision.terms) sum += term.raw * term.weight;
  EXPECT_NEAR(decision.total, sum, 1e-9);
  EXPECT_EQ(decision.terms.back().name, "OperatorDeviation");
  EXPECT_EQ(decision.terms.size(), 10u);  // nine critics, and the deviation
}

TEST(PlannerOutcome, NothingLegalBrakesWhileMovingThenFails) {
  // Obstacles everywhere, and no way out of a collision.
  Scene scene = driving(0.3);
  scene.fill(-9.0, -9.0, 9.0, 9.0);
  scene.parameters.method = Method::paper;
  PlannerBench bench(scene);
  const Decision& moving = bench.drive();
  EXPECT_EQ(moving.outcome, Outcome::brake);
  EXPECT_NEAR(moving.command.v, 0.175, 1e-12);  // 0.3 - 2.5 * 0.05
  EXPECT_EQ(moving.legal, 0u);
  EXPECT_EQ(rejections_by(moving, "Collision"), moving.candidates);
  EXPECT_FALSE(moving.problem.empty());
  EXPECT_EQ(bench.drive().outcome, Outcome::brake);  // 0.05
  EXPECT_EQ(bench.drive().outcome, Outcome::brake);  // 0.0, from 0.05
  EXPECT_EQ(bench.drive().outcome, Outcome::fail);
}

TEST(PlannerOutcome, StopInfluenceBrakesAndHolds) {
  Scene scene = driving(0.3);
  scene.situation.velocity.omega = scene.situation.last_command.omega = -0.2;
  scene.intent.state = OperatorStateId::stopped;
  scene.intent.influence = Influence::stop;
  PlannerBench bench(scene);
  const Decision first = bench.drive();
  EXPECT_EQ(first.outcome, Outcome::brake);
  EXPECT_NEAR(first.command.v, 0.175, 1e-12);
  EXPECT_NEAR(first.command.omega, -0.04, 1e-12);  // -0.2 + 3.2 * 0.05
  EXPECT_NEAR(bench.drive().command.v, 0.05, 1e-12);
  for (int k = 0; k < 60; ++k) {  // three seconds: holding is no failure
    const Decision& held = bench.drive();
    EXPECT_EQ(held.outcome, Outcome::hold);
    EXPECT_TRUE(held.command == Twist2{});
  }
}

TEST(PlannerRejections, AddUpAndAreNamedInOrder) {
  Scene scene = driving();
  scene.fill(0.1, -0.55, 9.0, 9.0, cost::kInscribed);
  scene.fill(0.45, -0.35, 0.7, 9.0);  // ahead and to the left
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  std::size_t sum = decision.legal;
  for (const RejectionCount& rejection : decision.rejections) sum += rejection.count;
  EXPECT_EQ(sum, decision.candidates);
  EXPECT_GT(rejections_by(decision, "Collision"), 0u);
  EXPECT_GT(rejections_by(decision, "BaseObstacle"), 0u);
  EXPECT_GT(decision.legal, 0u);
  EXPECT_EQ(decision.rejections.front().name, "Collision");
  std::size_t rejected = 0;
  for (const CandidateReport& record : bench.planner().candidates()) {
    EXPECT_EQ(record.legal(), std::isfinite(record.total));
    EXPECT_LE(record.rejections.size(), 1u);
    rejected += !record.legal();
  }
  EXPECT_EQ(rejected, decision.candidates - decision.legal);
}

TEST(PlannerMarks, BestWorstAndTheOperatorsOwn) {
  Scene scene = driving();
  scene.steer({0.5, 0.33});
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  const Planner::Marked marked = bench.planner().marked();
  const std::vector<CandidateReport> records = bench.planner().candidates();
  ASSERT_GE(marked.best, 0);
  EXPECT_TRUE(records[static_cast<std::size_t>(marked.best)].sample == decision.sample);
  EXPECT_EQ(records[static_cast<std::size_t>(marked.best)].total, decision.total);
  EXPECT_TRUE(records[static_cast<std::size_t>(marked.operator_command)].sample == (Twist2{0.5, 0.33}));
  for (const CandidateReport& record : records) {
    if (record.legal()) {
      EXPECT_LE(record.total, records[static_cast<std::size_t>(marked.worst)].total);
    }
  }
}

TEST(PlannerSampling, NumbersOfOneCycleOverrideTheParameters) {
  PlannerBench bench(driving());
  const Sampling sampling{5, 4};
  const Decision& decision =
      bench.planner().plan(bench.scene().situation, bench.scene().grid(), bench.scene().intent, sampling);
  EXPECT_EQ(decision.candidates,
            5u * 5u - 1u + 2u);  // 5 x (4 and 0) without (0, 0); stopping, the last command
}

TEST(PlannerConfigure, ASetIsTakenWholeOrNotAtAll) {
  Planner planner(critics::built_in());
  Parameters p;
  p.max_vel_x = 0.7;
  ASSERT_TRUE(planner.configure(p).empty());
  p.max_vel_x = 0.9;
  p.sim_time = -1.0;
  p.critics = "PathDist, Nonsense, Rubbish";
  const std::vector<std::string> faults = planner.configure(p);
  EXPECT_EQ(faults.size(), 3u);
  EXPECT_NE(faults[1].find("Nonsense"), std::string::npos);
  EXPECT_NE(faults[1].find("PathAlign"), std::string::npos);  // says which there are
  EXPECT_EQ(planner.parameters().max_vel_x, 0.7);
  EXPECT_EQ(planner.parameters().critics, Parameters().critics);
}

TEST(PlannerConfigure, TakesEffectInTheNextCycleAndPadsTheFootprint) {
  PlannerBench bench(driving());
  EXPECT_EQ(bench.cycle().sample.v, 0.5);
  Parameters p = bench.scene().parameters;
  p.max_vel_x = 0.3;
  p.footprint_padding = 0.05;
  ASSERT_TRUE(bench.planner().configure(p).empty());
  EXPECT_LE(bench.cycle().sample.v, 0.3);
  EXPECT_NEAR(bench.planner().footprint().inscribed_radius(), 0.25, 1e-12);
}

TEST(PlannerConfigure, CriticsThatStayKeepWhatTheyLatched) {
  // In the goal's tolerance at rest RotateToGoal latches; slid out again it must still reject to drive.
  Scene scene = driving(0.0);
  scene.situation.goal = {0.2, 0.0, 1.5};
  PlannerBench bench(scene);
  bench.cycle();
  ASSERT_TRUE(bench.planner().configure(scene.parameters).empty());
  bench.scene().situation.pose.x = -0.3;
  EXPECT_GT(rejections_by(bench.cycle(), "RotateToGoal"), 300u);
  bench.planner().reset();
  EXPECT_EQ(rejections_by(bench.cycle(), "RotateToGoal"), 0u);
}

// As they stand in cycle messages.
TEST(Outcomes, HaveNames) {
  EXPECT_STREQ(to_string(Outcome::drive), "DRIVE");
  EXPECT_STREQ(to_string(Outcome::brake), "BRAKE");
  EXPECT_STREQ(to_string(Outcome::fail), "FAIL");
  EXPECT_STREQ(to_string(Outcome::hold), "HOLD");
}

}  // namespace
}  // namespace hidwa_local_planner
