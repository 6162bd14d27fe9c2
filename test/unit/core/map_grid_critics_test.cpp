// SPDX-License-Identifier: BSD-3-Clause
// PathDist, PathAlign, GoalDist, GoalAlign. Cells of 0.05 m, cell (30, 30) around the origin; the plan runs
// along y = 0 from x = -1 to x = 1, the goal is 8 m ahead.
#include <gtest/gtest.h>

#include "support/critic_bench.hpp"

namespace hidwa_local_planner {
namespace {

using test::CriticBench;
using test::Scene;

double raw(const std::string& critic, const Scene& scene, const Pose2& last) {
  CriticBench bench(critic, scene);
  bench.prepare();
  const test::CriticAnswer answer = bench.score({0.5, 0.0}, {{}, last});
  EXPECT_FALSE(answer.rejected()) << answer.reason;
  return answer.raw;
}

TEST(MapGridWeight, HalfTheScaleAMetre) {
  // Nav2: scale * resolution / 2 a cell, so scale / 2 a metre.
  EXPECT_EQ(CriticBench("PathDist", Scene::empty()).weight(), 16.0);
  EXPECT_EQ(CriticBench("PathAlign", Scene::empty()).weight(), 16.0);
  EXPECT_EQ(CriticBench("GoalDist", Scene::empty()).weight(), 12.0);
  EXPECT_EQ(CriticBench("GoalAlign", Scene::empty()).weight(), 12.0);
}

TEST(PathDist, DistanceOfTheLastPoseFromThePlan) {
  Scene scene = Scene::empty();
  EXPECT_EQ(raw("PathDist", scene, {0.5, 0.01, 0.3}), 0.0);
  EXPECT_NEAR(raw("PathDist", scene, {0.5, 0.3, 0.3}), 0.3, 1e-12);           // 6 cells up
  EXPECT_NEAR(raw("PathDist", scene, {1.2, 0.2, 0.0}), 0.01 * 4 * 7, 1e-12);  // 4 diagonals
  scene.parameters.method = Method::paper;
  EXPECT_NEAR(raw("PathDist", scene, {1.2, 0.2, 0.0}), 0.4, 1e-12);  // 4 + 4 cells
}

TEST(GoalDist, DistanceFromTheWindowsLastPose) {
  Scene scene = Scene::empty();
  EXPECT_NEAR(raw("GoalDist", scene, {0.5, 0.0, 0.0}), 0.5, 1e-12);
  EXPECT_NEAR(raw("GoalDist", scene, {0.5, 0.3, 0.0}), 0.01 * (6 * 7 + 4 * 5),
              1e-12);  // 6 diagonal, 4 straight
  scene.parameters.method = Method::paper;
  EXPECT_NEAR(raw("GoalDist", scene, {0.5, 0.3, 0.0}), 0.8, 1e-12);  // 10 + 6 cells
}

TEST(PathAlign, DistanceOfTheNoseFromThePlan) {
  Scene scene = Scene::empty();
  scene.parameters.forward_point_distance = 0.3;
  // The nose is 0.3 m to the left of (0.5, 0).
  EXPECT_NEAR(raw("PathAlign", scene, {0.5, 0.0, M_PI / 2}), 0.3, 1e-12);
  EXPECT_EQ(raw("PathAlign", scene, {0.5, 0.0, 0.0}), 0.0);
}

TEST(PathAlign, IsOffWithinTheNosesLengthOfTheGoal) {
  Scene scene = Scene::empty();
  scene.parameters.forward_point_distance = 0.3;
  scene.situation.goal = {0.29, 0.0, 0.0};
  EXPECT_EQ(raw("PathAlign", scene, {0.5, 0.0, M_PI / 2}), 0.0);
  scene.situation.goal = {0.31, 0.0, 0.0};
  EXPECT_NEAR(raw("PathAlign", scene, {0.5, 0.0, M_PI / 2}), 0.3, 1e-12);
}

TEST(GoalAlign, TheNoseAgainstTheGoalMovedAhead) {
  Scene scene = Scene::empty();
  scene.parameters.forward_point_distance = 0.3;
  // The local goal moves from x = 1.0 to 1.3, the nose from 0.5 to 0.8: 0.5 m remain.
  EXPECT_NEAR(raw("GoalAlign", scene, {0.5, 0.0, 0.0}), 0.5, 1e-12);
  // Turned left the nose is at (0.5, 0.3): 16 columns and 6 rows, 6 diagonal and 10 straight.
  EXPECT_NEAR(raw("GoalAlign", scene, {0.5, 0.0, M_PI / 2}), 0.01 * (6 * 7 + 10 * 5), 1e-12);
}

TEST(GeodesicLookUp, ABlockedNoseTakesTheCentresValue) {
  Scene scene = Scene::empty();
  scene.parameters.forward_point_distance = 0.3;
  scene.at({36, 36}) = cost::kInscribed;  // at (0.3, 0.3)
  // Centre at (0.3, 0), nose at (0.3, 0.3) in the blocked cell: the centre's 0 instead of 0.3.
  EXPECT_EQ(raw("PathAlign", scene, {0.3, 0.0, M_PI / 2}), 0.0);
}

TEST(GeodesicLookUp, ANoseOffTheMapTakesTheCentresValueThePapersMethodRejects) {
  Scene scene = Scene::empty();  // ends at 1.525 m
  scene.parameters.forward_point_distance = 0.3;
  EXPECT_NEAR(raw("PathAlign", scene, {0.5, 1.3, M_PI / 2}), 1.3, 1e-12);
  scene.parameters.method = Method::paper;
  CriticBench bench("PathAlign", scene);
  bench.prepare();
  EXPECT_TRUE(bench.score({0.5, 0.0}, {{}, {0.5, 1.3, M_PI / 2}}).rejected());
  EXPECT_FALSE(bench.score({0.5, 0.0}, {{}, {0.5, 1.2, M_PI / 2}}).rejected());
}

TEST(L1LookUp, WhereThePersonDecidesItRejectsNothing) {
  Scene scene = Scene::empty();  // ends at 1.525 m
  scene.parameters.forward_point_distance = 0.3;
  scene.parameters.method = Method::paper;
  scene.intent.influence = Influence::direct;
  // As far as nothing on the map is: 61 + 61 cells.
  EXPECT_NEAR(raw("PathAlign", scene, {0.5, 1.3, M_PI / 2}), 0.05 * (61 + 61), 1e-12);
  scene.intent.influence = Influence::shared;
  scene.situation.goal_latched = true;
  EXPECT_NEAR(raw("PathAlign", scene, {0.5, 1.3, M_PI / 2}), 0.05 * (61 + 61), 1e-12);
}

TEST(GeodesicLookUp, UnreachedIsFarButLegal) {
  Scene scene = Scene::empty();
  for (int j = 0; j < 61; ++j) scene.at({34, j}) = cost::kLethal;
  for (int i = 0; i < 61; ++i) scene.at({i, 34}) = cost::kLethal;
  scene.situation.plan = {{-1.0, -1.0, 0.0}};
  EXPECT_NEAR(raw("PathDist", scene, {1.0, 1.0, 0.0}), 0.05 * (61 + 61), 1e-12);
}

TEST(OffTheMap, TheBearingToTheNearestPlanPose) {
  Scene scene = Scene::empty();
  scene.situation.plan = {{10.0, 10.0, 0.0}, {0.0, 20.0, 0.0}};  // (10, 10) is nearest: 14.1 m
  // From (0, 0) heading 0 the bearing is pi / 4 off; heading it, nothing.
  EXPECT_NEAR(raw("GoalDist", scene, {0.0, 0.0, 0.0}), M_PI / 4, 1e-12);
  EXPECT_NEAR(raw("PathAlign", scene, {0.0, 0.0, M_PI / 4}), 0.0, 1e-12);
  EXPECT_NEAR(raw("PathDist", scene, {0.0, 0.0, -M_PI / 2}), 3 * M_PI / 4, 1e-12);
}

}  // namespace
}  // namespace hidwa_local_planner
