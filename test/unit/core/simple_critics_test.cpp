// SPDX-License-Identifier: BSD-3-Clause
// BaseObstacle, ObstacleFootprint, PreferForward, Twirling.
#include <gtest/gtest.h>

#include "support/critic_bench.hpp"
#include "support/round_outline.hpp"

namespace hidwa_local_planner {
namespace {

using test::CriticAnswer;
using test::CriticBench;
using test::Scene;

TEST(PreferForward, BackwardsCreepingAndTurning) {
  Scene scene = Scene::empty();
  scene.parameters.PreferForward_penalty = 3.0;
  CriticBench bench("PreferForward", scene);
  bench.prepare();
  const auto raw = [&](const Twist2& u) { return bench.score(u, {{}, {}}).raw; };
  EXPECT_EQ(raw({-0.1, 0.9}), 3.0);          // backwards
  EXPECT_EQ(raw({0.09, 0.19}), 3.0);         // creeps: below 0.1 m/s and 0.2 rad/s
  EXPECT_DOUBLE_EQ(raw({0.09, -0.2}), 2.0);  // turns: |omega| * 10
  EXPECT_DOUBLE_EQ(raw({0.1, 0.1}), 1.0);
  EXPECT_EQ(raw({0.5, 0.0}), 0.0);
}

TEST(Twirling, TheTurnItself) {
  CriticBench bench("Twirling", Scene::empty());
  bench.prepare();
  EXPECT_EQ(bench.score({0.5, -0.7}, {{}, {}}).raw, 0.7);
  EXPECT_EQ(bench.score({0.5, 0.0}, {{}, {}}).raw, 0.0);
}

// Cells of 0.05 m; cell (i, j) is centred at ((i - 30) * 0.05, (j - 30) * 0.05).
Scene costly() {
  Scene scene = Scene::empty();
  scene.at({31, 30}) = 10;
  scene.at({32, 30}) = 100;
  scene.at({33, 30}) = 252;
  scene.at({34, 30}) = cost::kInscribed;
  scene.at({30, 34}) = cost::kLethal;
  scene.at({26, 30}) = cost::kUnknown;
  return scene;
}

const std::vector<Pose2> kToTheRight{{}, {0.05, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.15, 0.0, 0.0}};

TEST(BaseObstacle, TheLastCellsCost) {
  Scene scene = costly();
  CriticBench last("BaseObstacle", scene);
  last.prepare();
  EXPECT_EQ(last.weight(), 0.02);
  EXPECT_EQ(last.score({0.5, 0.0}, kToTheRight).raw, 252.0);
}

TEST(BaseObstacle, RejectsLethalInscribedUnknownAndTheEdge) {
  CriticBench bench("BaseObstacle", costly());
  bench.prepare();
  EXPECT_TRUE(bench.score({0.5, 0.0}, {{}, {0.2, 0.0, 0.0}, {0.3, 0.0, 0.0}}).rejected());  // passes inscribed
  EXPECT_TRUE(bench.score({0.5, 0.0}, {{}, {0.0, 0.2, 0.0}}).rejected());                   // ends in lethal
  EXPECT_TRUE(bench.score({0.5, 0.0}, {{}, {-0.2, 0.0, 0.0}}).rejected());                  // unknown
  EXPECT_TRUE(bench.score({0.5, 0.0}, {{}, {1.53, 0.5, 0.0}}).rejected());                  // beyond 1.525
  EXPECT_FALSE(bench.score({0.5, 0.0}, {{}, {0.3, 0.3, 0.0}}).rejected());
  Scene scene = costly();
  scene.parameters.unknown_is_obstacle = false;
  CriticBench tolerant("BaseObstacle", scene);
  tolerant.prepare();
  EXPECT_FALSE(tolerant.score({0.5, 0.0}, {{}, {-0.2, 0.0, 0.0}}).rejected());
}

TEST(BaseObstacle, FromWithinAnObstacleItLetsOutWhereEscapeIsOn) {
  Scene scene = costly();
  scene.situation.pose = {0.2, 0.0, 0.0};  // in the inscribed cell
  CriticBench bench("BaseObstacle", scene);
  bench.prepare();
  EXPECT_FALSE(bench.score({-0.1, 0.0}, {{0.2, 0.0, 0.0}, {0.1, 0.0, 0.0}}).rejected());
  scene.parameters.escape = false;
  CriticBench strict("BaseObstacle", scene);
  strict.prepare();
  EXPECT_TRUE(strict.score({-0.1, 0.0}, {{0.2, 0.0, 0.0}, {0.1, 0.0, 0.0}}).rejected());
}

// The outline reaches 0.2 m each way.
TEST(ObstacleFootprint, TheOutlinesLargestCostAtTheLastPose) {
  Scene scene = Scene::empty();
  scene.at({38, 30}) = 70;   // at 0.4: under the front edge when the robot is at x = 0.2
  scene.at({40, 30}) = 120;  // at 0.5: under it at x = 0.3
  scene.at({33, 30}) = 250;  // at 0.15: always inside, never under the outline
  const std::vector<Pose2> poses{{}, {0.2, 0.0, 0.0}, {0.3, 0.0, 0.0}};
  CriticBench last("ObstacleFootprint", scene);
  last.prepare();
  EXPECT_EQ(last.weight(), 0.01);
  EXPECT_EQ(last.score({0.5, 0.0}, poses).raw, 120.0);
}

TEST(ObstacleFootprint, RejectsLethalUnknownAndTheEdgeUnderTheOutlineOnly) {
  Scene scene = Scene::empty();
  scene.at({38, 30}) = cost::kLethal;  // at 0.4
  scene.at({22, 30}) = cost::kUnknown;
  scene.at({30, 38}) = cost::kInscribed;
  CriticBench bench("ObstacleFootprint", scene);
  bench.prepare();
  EXPECT_TRUE(bench.score({0.5, 0.0}, {{}, {0.2, 0.0, 0.0}}).rejected());
  EXPECT_TRUE(bench.score({0.5, 0.0}, {{}, {0.2, 0.0, 0.0}, {0.0, 0.0, 0.0}}).rejected());  // on the way, too
  EXPECT_TRUE(bench.score({0.5, 0.0}, {{}, {-0.2, 0.0, 0.0}}).rejected());
  EXPECT_TRUE(bench.score({0.5, 0.0}, {{}, {1.34, -0.6, 0.0}}).rejected());  // front at 1.54
  EXPECT_FALSE(bench.score({0.5, 0.0}, {{}, {0.0, 0.2, 0.0}}).rejected());   // inscribed is allowed
  EXPECT_FALSE(bench.score({0.5, 0.0}, {{}, {0.4, 0.0, 0.0}}).rejected());   // lethal, but inside
  scene.parameters.unknown_is_obstacle = false;
  CriticBench tolerant("ObstacleFootprint", scene);
  tolerant.prepare();
  EXPECT_FALSE(tolerant.score({0.5, 0.0}, {{}, {-0.2, 0.0, 0.0}}).rejected());
}

TEST(ObstacleFootprint, FromWithinAnObstacleItLetsOutWhereEscapeIsOn) {
  Scene scene = Scene::empty();
  scene.at({34, 30}) = cost::kLethal;  // at 0.2: under the front edge at the start
  CriticBench bench("ObstacleFootprint", scene);
  bench.prepare();
  const std::vector<Pose2> away{{}, {-0.05, 0.0, 0.0}};
  EXPECT_FALSE(bench.score({-0.1, 0.0}, away).rejected());
  scene.parameters.escape = false;
  CriticBench strict("ObstacleFootprint", scene);
  strict.prepare();
  EXPECT_TRUE(strict.score({-0.1, 0.0}, away).rejected());
}

TEST(ObstacleFootprint, ACircleHasAnOutlineToo) {
  Scene scene = Scene::empty();
  scene.outline = test::round_outline(0.2);
  scene.at({30, 38}) = cost::kLethal;  // from y = 0.375 on
  CriticBench bench("ObstacleFootprint", scene);
  bench.prepare();
  EXPECT_TRUE(bench.score({0.5, 0.0}, {{}, {0.0, 0.18, 0.0}}).rejected());   // top at 0.38
  EXPECT_FALSE(bench.score({0.5, 0.0}, {{}, {0.0, 0.17, 0.0}}).rejected());  // 0.37
}

}  // namespace
}  // namespace hidwa_local_planner
