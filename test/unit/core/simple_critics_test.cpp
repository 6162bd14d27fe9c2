// SPDX-License-Identifier: BSD-3-Clause
// BaseObstacle, ObstacleFootprint and PreferForward by hand; test/oracle/planner_twin_test.cpp compares them, and
// Twirling, in random scenes.
#include <gtest/gtest.h>

#include "support/critic_bench.hpp"

namespace hidwa_local_planner {
namespace {

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

// Cells of 0.05 m; cell (i, j) is centred at ((i - 30) * 0.05, (j - 30) * 0.05).
Scene among_obstacles() {
  Scene scene = Scene::empty();
  scene.at({38, 30}) = cost::kLethal;
  scene.at({22, 30}) = cost::kUnknown;
  scene.at({30, 38}) = cost::kInscribed;
  return scene;
}

bool rejects(const char* critic, const Scene& scene, const std::vector<Pose2>& poses) {
  CriticBench bench(critic, scene);
  bench.prepare();
  return bench.score({0.5, 0.0}, poses).rejected();
}

struct Case {
  const char* where;
  Pose2 pose;
  bool base_obstacle, obstacle_footprint;  // whether they reject it
};

// BaseObstacle looks at the cell under the centre, ObstacleFootprint at those under the outline, 0.2 m from it.
TEST(ObstacleCritics, RejectWhatLiesUnderTheCentreOrUnderTheOutline) {
  const Case cases[] = {
      {"the centre is in the lethal cell", {0.4, 0.0, 0.0}, true, false},
      {"the front is", {0.2, 0.0, 0.0}, false, true},
      {"the centre is in the unknown cell", {-0.4, 0.0, 0.0}, true, false},
      {"the rear is", {-0.2, 0.0, 0.0}, false, true},
      {"the centre is in the inscribed cell", {0.0, 0.4, 0.0}, true, false},
      {"the left side is", {0.0, 0.2, 0.0}, false, false},
      {"the centre is beyond the map's edge at 1.525", {1.53, -0.6, 0.0}, true, true},
      {"the front is", {1.34, -0.6, 0.0}, false, true},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.where);
    const Scene scene = among_obstacles();
    EXPECT_EQ(rejects("BaseObstacle", scene, {{}, c.pose}), c.base_obstacle);
    EXPECT_EQ(rejects("BaseObstacle", scene, {{}, c.pose, {}}), c.base_obstacle) << "on the way";
    EXPECT_EQ(rejects("ObstacleFootprint", scene, {{}, c.pose}), c.obstacle_footprint);
    EXPECT_EQ(rejects("ObstacleFootprint", scene, {{}, c.pose, {}}), c.obstacle_footprint) << "on the way";
  }
}

TEST(ObstacleCritics, TakeUnknownCellsForFreeOnesOnDemand) {
  Scene scene = among_obstacles();
  scene.parameters.unknown_is_obstacle = false;
  EXPECT_FALSE(rejects("BaseObstacle", scene, {{}, {-0.4, 0.0, 0.0}}));
  EXPECT_FALSE(rejects("ObstacleFootprint", scene, {{}, {-0.2, 0.0, 0.0}}));
}

// At the start its centre is in an inscribed cell, and its front in a lethal one.
TEST(ObstacleCritics, LetOutOfAnObstacleButInThePapersMethod) {
  Scene scene = Scene::empty();
  scene.at({30, 30}) = cost::kInscribed;
  scene.at({34, 30}) = cost::kLethal;
  for (const Method method : {Method::hidwa, Method::paper}) {
    scene.parameters.method = method;
    for (const char* critic : {"BaseObstacle", "ObstacleFootprint"}) {
      EXPECT_EQ(rejects(critic, scene, {{}, {-0.1, 0.0, 0.0}}), method == Method::paper) << critic;
    }
  }
}

}  // namespace
}  // namespace hidwa_local_planner
