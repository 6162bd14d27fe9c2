// SPDX-License-Identifier: BSD-3-Clause
// PathDist, PathAlign, GoalDist, GoalAlign by hand; test/oracle/planner_twin_test.cpp compares them in random scenes.
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

// Cells of 0.05 m; the plan runs along y = 0 from x = -1 to x = 1, the goal is 8 m ahead, the map ends at 1.525 m. The
// nose is 0.3 m ahead of the robot. Distances go straight and diagonally, 5 and 7 hundredths of a metre a cell; the
// paper's method counts columns and rows.
struct Example {
  const char* what;
  const char* critic;
  Method method;
  Pose2 last;
  double raw;  // [m]
};

TEST(MapGridCritics, ScoreDistancesOnTheMap) {
  constexpr double kLeft = 0.5 * M_PI;
  const Example examples[] = {
      {"6 cells beside the plan", "PathDist", Method::hidwa, {0.5, 0.3, 0.3}, 0.3},
      {"4 diagonals beyond the plan's end", "PathDist", Method::hidwa, {1.2, 0.2, 0.0}, 0.01 * 4 * 7},
      {"4 columns and 4 rows beyond it", "PathDist", Method::paper, {1.2, 0.2, 0.0}, 0.4},
      {"6 diagonals and 4 straight cells from its end", "GoalDist", Method::hidwa, {0.5, 0.3, 0.0}, 0.01 * (42 + 20)},
      {"10 columns and 6 rows from it", "GoalDist", Method::paper, {0.5, 0.3, 0.0}, 0.8},
      {"the nose is on the plan", "PathAlign", Method::hidwa, {0.5, 0.0, 0.0}, 0.0},
      {"the nose is beside it", "PathAlign", Method::hidwa, {0.5, 0.0, kLeft}, 0.3},
      {"the nose is off the map: the centre counts", "PathAlign", Method::hidwa, {0.5, 1.3, kLeft}, 1.3},
      {"the nose at 0.8 is as far from the end, moved ahead to 1.3", "GoalAlign", Method::hidwa, {0.5, 0.0, 0.0}, 0.5},
      {"the nose is 16 columns and 6 rows from there", "GoalAlign", Method::hidwa, {0.5, 0.0, kLeft}, 0.01 * (42 + 50)},
  };
  for (const Example& example : examples) {
    Scene scene = Scene::empty();
    scene.parameters.forward_point_distance = 0.3;
    scene.parameters.method = example.method;
    EXPECT_NEAR(raw(example.critic, scene, example.last), example.raw, 1e-12) << example.critic << ": " << example.what;
  }
}

TEST(MapGridCritics, ABlockedNoseTakesTheCentresValue) {
  Scene scene = Scene::empty();
  scene.parameters.forward_point_distance = 0.3;
  scene.at({36, 36}) = cost::kInscribed;  // at (0.3, 0.3)
  EXPECT_EQ(raw("PathAlign", scene, {0.3, 0.0, M_PI / 2}), 0.0);
}

TEST(MapGridCritics, ThePapersMethodRejectsANoseOffTheMapWhereNoPersonDecides) {
  Scene scene = Scene::empty();
  scene.parameters.forward_point_distance = 0.3;
  scene.parameters.method = Method::paper;
  const Pose2 beyond{0.5, 1.3, M_PI / 2}, inside{0.5, 1.2, M_PI / 2};
  CriticBench bench("PathAlign", scene);
  bench.prepare();
  EXPECT_TRUE(bench.score({0.5, 0.0}, {{}, beyond}).rejected());
  EXPECT_FALSE(bench.score({0.5, 0.0}, {{}, inside}).rejected());
  // As far as nothing on the map is: 61 + 61 cells.
  scene.intent.influence = Influence::direct;
  EXPECT_NEAR(raw("PathAlign", scene, beyond), 0.05 * (61 + 61), 1e-12);
  scene.intent.influence = Influence::shared;
  scene.situation.goal_latched = true;
  EXPECT_NEAR(raw("PathAlign", scene, beyond), 0.05 * (61 + 61), 1e-12);
}

TEST(MapGridCritics, UnreachedIsFarButLegal) {
  Scene scene = Scene::empty();
  for (int j = 0; j < 61; ++j) scene.at({34, j}) = cost::kLethal;
  for (int i = 0; i < 61; ++i) scene.at({i, 34}) = cost::kLethal;
  scene.situation.plan = {{-1.0, -1.0, 0.0}};
  EXPECT_NEAR(raw("PathDist", scene, {1.0, 1.0, 0.0}), 0.05 * (61 + 61), 1e-12);
}

TEST(MapGridCritics, OffTheMapTheBearingToTheNearestPlanPoseCounts) {
  Scene scene = Scene::empty();
  scene.situation.plan = {{10.0, 10.0, 0.0}, {0.0, 20.0, 0.0}};  // (10, 10) is nearest: 14.1 m
  // From (0, 0) heading 0 the bearing is pi / 4 off.
  EXPECT_NEAR(raw("GoalDist", scene, {0.0, 0.0, 0.0}), M_PI / 4, 1e-12);
  EXPECT_NEAR(raw("PathDist", scene, {0.0, 0.0, -M_PI / 2}), 3 * M_PI / 4, 1e-12);
}

}  // namespace
}  // namespace hidwa_local_planner
