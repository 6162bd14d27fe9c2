// SPDX-License-Identifier: BSD-3-Clause
// A host whose plans change sides: a pillar stands in the way, and each second the plan leads round its other side.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "plan_drive.hpp"

namespace hidwa_local_planner::test {
namespace {

const Pose2 kPillar{4.0, 0.0, 0.0};
const Pose2 kGoal{8.0, 0.0, 0.0};

// From the robot to the goal, round the pillar at a distance of 1 m to a side (1: left, -1: right).
PlanShape plan_round(const Pose2& from, double side) {
  PlanShape plan{from};
  if (from.x < kPillar.x) go_to(plan, kPillar.x, side);
  go_to(plan, kGoal.x, kGoal.y);
  plan.back() = kGoal;
  return plan;
}

struct Passage {
  double duration = 0.0;  // until the robot is past the pillar [s]
  int swings = 0;         // how often it changes from turning left to turning right, or back
};

Passage drive(double wait) {
  Parameters parameters;
  parameters.plan_hysteresis_time = wait;
  parameters.comfort_acc_lim_theta = 0.0;
  PlanDrive robot(parameters);
  robot.obstacle = [](double x, double y) { return std::max(std::abs(x - kPillar.x), std::abs(y - kPillar.y)) < 0.3; };
  robot.host = [next = 0.0, side = 1.0](PlanDrive& drive) mutable {
    if (drive.time() < next) return;
    drive.plan(plan_round(drive.pose(), side));
    next += 1.0;
    side = -side;
  };
  constexpr double kPeriod = 0.05;  // [s]
  const PlanShape track = robot.run(60.0).track;
  Passage passage;
  double turning = 0.0;  // [rad/s]
  for (std::size_t k = 1; k < track.size() && track[k - 1].x < kPillar.x + 0.5; ++k) {
    passage.duration += kPeriod;
    const double omega = wrap_angle(track[k].theta - track[k - 1].theta) / kPeriod;
    if (std::abs(omega) < 0.2) continue;
    if (turning * omega < 0.0) ++passage.swings;
    turning = omega;
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
