// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/rest.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "control/fault_brake.hpp"
#include "core/motion/velocity_limits.hpp"
#include "support/planner_bench.hpp"

namespace hidwa_local_planner {
namespace {

using test::PlannerBench;
using test::Scene;

Parameters stopped_at(double v, double omega) {
  Parameters p;
  p.trans_stopped_velocity = v;
  p.rot_stopped_velocity = omega;
  return p;
}

TEST(Rest, AMeasuredVelocityIsRestUpToTheStoppedVelocities) {
  const Parameters p = stopped_at(0.1, 0.3);
  EXPECT_TRUE(at_rest({0.0, 0.0}, p));
  EXPECT_TRUE(at_rest({-0.1, 0.3}, p));
  EXPECT_FALSE(at_rest({0.1001, 0.0}, p));
  EXPECT_FALSE(at_rest({0.0, -0.3001}, p));
  EXPECT_FALSE(at_rest({std::numeric_limits<double>::quiet_NaN(), 0.0}, p));
}

TEST(Rest, ACommandAsksForRestWhereItIsZeroUpToRounding) {
  EXPECT_TRUE(commands_rest({0.0, -0.0}));
  EXPECT_TRUE(commands_rest({0.3 - 0.1 - 0.2, 0.0}));  // -2.8e-17
  EXPECT_FALSE(commands_rest({5e-4, 0.0}));
  EXPECT_FALSE(commands_rest({0.0, -5e-4}));
}

TEST(Rest, ARobotStandsOnlyIfItIsNotToldToDrive) {
  const Parameters p = stopped_at(0.1, 0.3);
  EXPECT_TRUE(stands({}, {0.05, 0.1}, p));
  EXPECT_FALSE(stands({0.01, 0.0}, {}, p));  // it has not begun yet
  EXPECT_FALSE(stands({}, {0.2, 0.0}, p));   // it still rolls
}

// No pose of the plan lies on the map: there is nothing to follow.
Outcome without_a_way(const Twist2& measured, const Twist2& last_command) {
  Scene scene = Scene::empty();
  for (Pose2& pose : scene.situation.plan) pose.x += 100.0;
  scene.situation.velocity = measured;
  scene.situation.last_command = last_command;
  return PlannerBench(scene).cycle().outcome;
}

// Odometry of a robot that stands shows some millimetres a second. The host must hear of the failure all the same.
TEST(Rest, NoiseOfOdometryDoesNotHideThatThereIsNoWay) {
  EXPECT_EQ(without_a_way({0.02, -0.03}, {}), Outcome::fail);
  EXPECT_EQ(without_a_way({0.0, 0.0}, {}), Outcome::fail);
  EXPECT_EQ(without_a_way({0.15, 0.0}, {}), Outcome::brake);         // 0.1 m/s is rest here
  EXPECT_EQ(without_a_way({0.0, 0.0}, {0.2, 0.0}), Outcome::brake);  // odometry does not show the command yet
}

TEST(Rest, NoiseOfOdometryDoesNotHideThatThereIsNoWayOut) {
  Scene scene = Scene::empty();
  scene.fill(-9.0, -9.0, 9.0, 9.0);
  PlannerBench bench(scene);
  Outcome outcome = Outcome::hold;
  for (int k = 0; k < 30; ++k) {
    bench.scene().situation.velocity = {k % 2 == 0 ? 0.01 : -0.01, 0.0};
    outcome = bench.cycle().outcome;
    EXPECT_EQ(outcome == Outcome::fail, k >= 20) << k;  // 20 periods of 0.05 s are 1 s
    bench.scene().situation.time += bench.scene().situation.period;
  }
}

// A base with weak motors begins with commands this small.
TEST(Rest, TheFirstStepOfAWeakBaseIsDriving) {
  Scene scene = Scene::empty();
  scene.parameters.acc_lim_x = 0.01;  // 0.5 mm/s in a period
  scene.steer({0.5, 0.0});
  scene.intent.influence = Influence::direct;
  scene.intent.guarded = false;
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  EXPECT_NEAR(decision.command.v, 5e-4, 1e-9);
  EXPECT_EQ(decision.outcome, Outcome::drive);
}

TEST(Rest, ARobotThatStopsHoldsOnlyOnceItsCommandIsZero) {
  Scene scene = Scene::empty();
  scene.intent.influence = Influence::stop;
  scene.situation.velocity = scene.situation.last_command = {0.1255, 0.0};  // a period takes 0.125 m/s
  PlannerBench bench(scene);
  EXPECT_EQ(bench.drive().outcome, Outcome::brake);
  EXPECT_EQ(bench.drive().outcome, Outcome::hold);
}

TEST(Rest, TheFaultBrakeDoesNotBrakeForARoundingError) {
  FaultBrake brake;
  EXPECT_FALSE(
      brake.brake(10.0, Twist2{}, Twist2{0.3 - 0.1 - 0.2, 0.0}, Parameters(), VelocityLimits::from({}), 0.05).success);
}

}  // namespace
}  // namespace hidwa_local_planner
