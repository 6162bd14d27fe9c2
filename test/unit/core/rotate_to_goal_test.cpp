// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/critic_bench.hpp"

namespace hidwa_local_planner {
namespace {

using test::CriticAnswer;
using test::CriticBench;
using test::Scene;

// Tolerance 0.25 m, stopped below 0.1 m/s, slowing factor 5. The goal at the origin looks along 1.0 rad. The turn need
// not end gently.
CriticBench bench_at(double x, double v) {
  Scene scene = Scene::empty();
  scene.situation.goal = {0.0, 0.0, 1.0};
  scene.situation.pose = {x, 0.0, 0.0};
  scene.situation.velocity = {v, 0.0};
  scene.parameters.comfort_acc_lim_theta = 0.0;
  return CriticBench("RotateToGoal", scene);
}

const std::vector<Pose2> kEndsAtPointFour{{}, {0.1, 0.0, 0.4}};

TEST(RotateToGoal, OutsideTheToleranceItSaysNothing) {
  CriticBench bench = bench_at(0.26, 0.4);
  bench.prepare();
  const CriticAnswer answer = bench.score({0.5, 0.0}, kEndsAtPointFour);
  EXPECT_FALSE(answer.rejected());
  EXPECT_EQ(answer.raw, 0.0);
  EXPECT_EQ(bench.weight(), 32.0);
}

TEST(RotateToGoal, StillDrivingInsideItMustSlowDown) {
  CriticBench bench = bench_at(0.24, 0.4);
  bench.prepare();
  EXPECT_TRUE(bench.score({0.4, 0.0}, kEndsAtPointFour).rejected());
  EXPECT_TRUE(bench.score({-0.4, 0.0}, kEndsAtPointFour).rejected());
  const CriticAnswer slower = bench.score({0.3, 0.0}, kEndsAtPointFour);
  EXPECT_FALSE(slower.rejected());
  EXPECT_NEAR(slower.raw, 0.09 * 5.0 + 0.6, 1e-12);  // v^2 * 5 + |1.0 - 0.4|
}

TEST(RotateToGoal, StoppedItOnlyTurns) {
  CriticBench bench = bench_at(0.24, 0.1);
  bench.prepare();
  EXPECT_TRUE(bench.score({0.05, 0.5}, kEndsAtPointFour).rejected());
  EXPECT_TRUE(bench.score({-0.05, 0.5}, kEndsAtPointFour).rejected());
  const CriticAnswer turning = bench.score({0.0, 0.5}, kEndsAtPointFour);
  EXPECT_FALSE(turning.rejected());
  EXPECT_NEAR(turning.raw, 0.6, 1e-12);
}

TEST(RotateToGoal, ItRejectsThePersonNothing) {
  for (const Influence influence : {Influence::shared, Influence::direct}) {
    for (const double v : {0.4, 0.1}) {  // still driving; stopped
      CriticBench bench = bench_at(0.24, v);
      bench.scene().intent.influence = influence;
      bench.prepare();
      const CriticAnswer forwards = bench.score({0.5, 0.0}, kEndsAtPointFour);
      EXPECT_FALSE(forwards.rejected()) << forwards.reason;
      EXPECT_FALSE(bench.score({-0.5, 0.5}, kEndsAtPointFour).rejected());
      // The heading error |1.0 - 0.4|, and v^2 * 5 = 0.25 * 5 while still driving: only the rejection is gone.
      EXPECT_NEAR(forwards.raw, v > 0.1 ? 1.25 + 0.6 : 0.6, 1e-12);
      bench.scene().intent = OperatorIntent();
      bench.prepare();
      EXPECT_TRUE(bench.score({0.5, 0.0}, kEndsAtPointFour).rejected());  // autonomy again
    }
  }
}

TEST(RotateToGoal, TheHeadingErrorIsTheShortWayRound) {
  CriticBench bench = bench_at(0.0, 0.0);
  bench.scene().situation.goal.theta = 3.0;
  bench.prepare();
  // From -3.0 to 3.0 it is 2 pi - 6.
  EXPECT_NEAR(bench.score({0.0, 0.5}, {{}, {0.0, 0.0, -3.0}}).raw, 2.0 * M_PI - 6.0, 1e-12);
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
}

TEST(RotateToGoal, LookaheadInterpolatesBetweenPoses) {
  Scene scene = Scene::empty();
  scene.situation.goal = {0.0, 0.0, 1.0};
  scene.parameters.comfort_acc_lim_theta = 0.0;
  CriticBench bench("RotateToGoal", scene);
  bench.prepare();
  // Steps of 0.2 s at headings 0, 0.1, 0.2, 0.4: 0.5 s lies halfway between 0.2 and 0.4.
  const std::vector<Pose2> poses{{}, {0, 0, 0.1}, {0, 0, 0.2}, {0, 0, 0.4}};
  EXPECT_NEAR(bench.score({0.0, 1.0}, poses, 0.2).raw, 1.0 - 0.3, 1e-12);
  EXPECT_NEAR(bench.score({0.0, 1.0}, poses, 0.1).raw, 0.6, 1e-12);  // it ends before: its end
  scene.parameters.method = Method::paper;
  CriticBench end("RotateToGoal", scene);
  end.prepare();
  EXPECT_NEAR(end.score({0.0, 1.0}, poses, 0.2).raw, 0.6, 1e-12);
}

TEST(RotateToGoal, AGentleTurnIsJudgedByWhereItComesToRest) {
  Scene scene = Scene::empty();
  scene.situation.goal = {0.0, 0.0, 1.0};
  scene.parameters.comfort_acc_lim_theta = 0.8;
  const std::vector<Pose2> poses{{}, {0, 0, 0.1}, {0, 0, 0.2}, {0, 0, 0.4}};
  const std::vector<double> omegas{0.2, 0.4, 0.6, 0.8};
  CriticBench bench("RotateToGoal", scene);
  bench.prepare();
  // At 0.5 s the heading is 0.3 rad and omega 0.7 rad/s: 0.49 / (2 * 0.8) rad until rest.
  EXPECT_NEAR(bench.score({0.0, 0.8}, poses, 0.2, omegas).raw, 1.0 - 0.3 - 0.49 / 1.6, 1e-12);
  bench.scene().steer({0.0, 0.8});  // the person's turn is theirs
  bench.prepare();
  EXPECT_NEAR(bench.score({0.0, 0.8}, poses, 0.2, omegas).raw, 1.0 - 0.3, 1e-12);
}

}  // namespace
}  // namespace hidwa_local_planner
