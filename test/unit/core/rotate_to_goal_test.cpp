// SPDX-License-Identifier: BSD-3-Clause
// By hand; test/oracle/planner_twin_test.cpp compares RotateToGoal in random scenes.
#include <gtest/gtest.h>

#include "support/critic_bench.hpp"

namespace hidwa_local_planner {
namespace {

using test::CriticAnswer;
using test::CriticBench;
using test::Scene;

// Tolerance 0.25 m, stopped below 0.1 m/s, slowing factor 5. The goal at the origin looks along 1.0 rad. The turn need
// not end gently.
CriticBench bench_at(double x, double v, Influence influence = Influence::none) {
  Scene scene = Scene::empty();
  scene.situation.goal = {0.0, 0.0, 1.0};
  scene.situation.pose = {x, 0.0, 0.0};
  scene.situation.velocity = {v, 0.0};
  scene.intent.influence = influence;
  scene.parameters.comfort_acc_lim_theta = 0.0;
  return CriticBench("RotateToGoal", scene);
}

const std::vector<Pose2> kEndsAtPointFour{{}, {0.1, 0.0, 0.4}};

struct Case {
  const char* what;
  double away;      // from the goal [m]
  double measured;  // [m/s]
  Influence influence;
  Twist2 candidate;
  double raw;  // kRejected: it is rejected
};
constexpr double kRejected = -1.0;

// The heading error is |1.0 - 0.4|.
TEST(RotateToGoal, SlowsDownAndTurnsWithinTheTolerance) {
  const Case cases[] = {
      {"outside the tolerance it says nothing", 0.26, 0.4, Influence::none, {0.5, 0.0}, 0.0},
      {"who drives must slow down", 0.24, 0.4, Influence::none, {0.4, 0.0}, kRejected},
      {"backwards too", 0.24, 0.4, Influence::none, {-0.4, 0.0}, kRejected},
      {"who slows down pays for v^2 and the heading", 0.24, 0.4, Influence::none, {0.3, 0.0}, 0.09 * 5.0 + 0.6},
      {"who has stopped only turns", 0.24, 0.1, Influence::none, {0.05, 0.5}, kRejected},
      {"backwards it does not drive either", 0.24, 0.1, Influence::none, {-0.05, 0.5}, kRejected},
      {"who turns pays for the heading", 0.24, 0.1, Influence::none, {0.0, 0.5}, 0.6},
      {"a person may drive on", 0.24, 0.4, Influence::shared, {0.5, 0.0}, 0.25 * 5.0 + 0.6},
      {"and set off again", 0.24, 0.1, Influence::direct, {0.5, 0.0}, 0.6},
  };
  for (const Case& c : cases) {
    CriticBench bench = bench_at(c.away, c.measured, c.influence);
    bench.prepare();
    const CriticAnswer answer = bench.score(c.candidate, kEndsAtPointFour);
    EXPECT_EQ(answer.rejected(), c.raw == kRejected) << c.what;
    if (c.raw != kRejected) {
      EXPECT_NEAR(answer.raw, c.raw, 1e-12) << c.what;
    }
  }
}

TEST(RotateToGoal, AutonomyIsRejectedAgainAfterThePerson) {
  CriticBench bench = bench_at(0.24, 0.4, Influence::shared);
  bench.prepare();
  bench.scene().intent = OperatorIntent();
  bench.prepare();
  EXPECT_TRUE(bench.score({0.5, 0.0}, kEndsAtPointFour).rejected());
}

TEST(RotateToGoal, BothLatchesHoldUntilANewGoal) {
  CriticBench bench = bench_at(0.24, 0.4);
  bench.prepare();
  bench.scene().situation.pose.x = 0.6;  // slid out of the tolerance
  bench.prepare();
  EXPECT_TRUE(bench.score({0.4, 0.0}, kEndsAtPointFour).rejected());
  bench.scene().situation.velocity.v = 0.05;  // stopped ...
  bench.prepare();
  bench.scene().situation.velocity.v = 0.4;  // ... and pushed on
  bench.prepare();
  EXPECT_TRUE(bench.score({0.05, 0.0}, kEndsAtPointFour).rejected());
  bench.critic().reset();
  bench.prepare();
  EXPECT_EQ(bench.score({0.4, 0.0}, kEndsAtPointFour).raw, 0.0);
  EXPECT_FALSE(bench.score({0.4, 0.0}, kEndsAtPointFour).rejected());
  bench.scene().situation.pose.x = 0.24;  // there again, and it has not stopped yet
  bench.prepare();
  EXPECT_FALSE(bench.score({0.3, 0.0}, kEndsAtPointFour).rejected());
}

TEST(RotateToGoal, AGentleTurnIsJudgedByWhereItComesToRest) {
  Scene scene = Scene::empty();
  scene.situation.goal = {0.0, 0.0, 1.0};
  scene.parameters.comfort_acc_lim_theta = 0.8;
  const std::vector<Pose2> poses{{}, {0, 0, 0.1}, {0, 0, 0.2}, {0, 0, 0.4}};
  const std::vector<double> omegas{0.2, 0.4, 0.6, 0.8};
  CriticBench bench("RotateToGoal", scene);
  bench.prepare();
  // Steps of 0.2 s: at 0.5 s, halfway between the last two, the heading is 0.3 rad and omega 0.7 rad/s: 0.49 / (2 *
  // 0.8) rad until rest.
  EXPECT_NEAR(bench.score({0.0, 0.8}, poses, 0.2, omegas).raw, 1.0 - 0.3 - 0.49 / 1.6, 1e-12);
  bench.scene().steer({0.0, 0.8});  // the person's turn is theirs
  bench.prepare();
  EXPECT_NEAR(bench.score({0.0, 0.8}, poses, 0.2, omegas).raw, 1.0 - 0.3, 1e-12);
}

}  // namespace
}  // namespace hidwa_local_planner
