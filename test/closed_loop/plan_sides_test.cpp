// SPDX-License-Identifier: BSD-3-Clause
// A host whose plans change sides: a pillar stands in the way, and each second the plan leads round its other side.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/scene_loop.hpp"

namespace hidwa_local_planner::test {
namespace {

const Pose2 kPillar{4.0, 0.0, 0.0};
const Pose2 kGoal{8.0, 0.0, 0.0};

// From the robot to the goal, round the pillar at a distance of 1 m to a side (1: left, -1: right).
std::vector<Pose2> plan_round(const Pose2& from, double side) {
  std::vector<Pose2> plan;
  const std::vector<Point> corners = {{from.x, from.y}, {kPillar.x, side}, {kGoal.x, kGoal.y}};
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const Point along = corners[k + 1] - corners[k];
    if (along.x() <= 0.0) continue;  // the robot is past it
    const double heading = std::atan2(along.y(), along.x());
    for (double s = 0.0; s < along.norm(); s += 0.05) {
      const Point p = corners[k] + s * along.normalized();
      plan.push_back({p.x(), p.y(), heading});
    }
  }
  plan.push_back(kGoal);
  return plan;
}

struct Passage {
  double duration = 0.0;  // until the robot is past the pillar [s]
  int swings = 0;         // how often it changes from turning left to turning right, or back
};

Passage drive(double wait) {
  Scene scene = Scene::empty(241, 0.05);
  scene.parameters = Parameters();
  scene.parameters.plan_hysteresis_time = wait;
  scene.parameters.comfort_acc_lim_theta = 0.0;
  scene.origin_x = -2.0;
  scene.origin_y = -6.0;
  scene.fill(kPillar.x - 0.3, kPillar.y - 0.3, kPillar.x + 0.3, kPillar.y + 0.3, cost::kLethal);
  scene.situation.pose = {0.0, 0.0, 0.0};
  scene.situation.time = 1.0;
  scene.situation.goal = kGoal;
  scene.situation.plan = plan_round(scene.situation.pose, 1.0);
  SceneLoop loop(scene);
  Passage passage;
  double turning = 0.0;
  for (int k = 0; k < 1200 && scene.situation.pose.x < kPillar.x + 0.5; ++k) {
    Situation& now = scene.situation;
    if (k % 20 == 0) {
      now.plan = plan_round(now.pose, k % 40 == 0 ? 1.0 : -1.0);
      loop.plan();
    }
    const Twist2 u = loop.cycle().command;
    carry_out(scene, u);
    passage.duration = now.time - 1.0;
    if (std::abs(u.omega) < 0.2) continue;
    if (turning * u.omega < 0.0) ++passage.swings;
    turning = u.omega;
  }
  return passage;
}

TEST(PlanSides, ARobotThatKeepsToItsSideIsPastThePillarSooner) {
  const Passage every = drive(0.0);
  const Passage kept = drive(Parameters().plan_hysteresis_time);
  RecordProperty("every_plan", std::to_string(every.duration) + " s, " + std::to_string(every.swings) + " swings");
  RecordProperty("kept", std::to_string(kept.duration) + " s, " + std::to_string(kept.swings) + " swings");
  // By (4, 1) to x = 4.5: hypot(4, 1) + 0.5 = 4.6 m, 9.3 s at 0.5 m/s, and the turns.
  EXPECT_LT(kept.duration, 12.0);
  EXPECT_LE(kept.swings, 3);
  EXPECT_GE(every.swings, kept.swings + 2);
}

}  // namespace
}  // namespace hidwa_local_planner::test
