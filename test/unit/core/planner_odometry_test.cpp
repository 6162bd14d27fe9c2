// SPDX-License-Identifier: BSD-3-Clause
// Odometry that cannot be true starts no command, one that is slower counts for collisions; old poses; late cycles.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "control/fault_brake.hpp"
#include "support/planner_bench.hpp"

namespace hidwa_local_planner {
namespace {

using test::PlannerBench;
using test::Scene;

constexpr double kPeriod = 0.05;      // [s]
constexpr double kStep = 2.5 * 0.05;  // of v in a period [m/s]
constexpr double kTurn = 3.2 * 0.05;  // of omega [rad/s]

const Twist2 kImpossible[] = {{5.0, 0.0}, {-3.0, 0.0}, {0.0, 20.0}, {0.0, -20.0}, {9.0, 30.0}};

Scene on_a_plan(const Twist2& driving = {}) {
  Scene scene = Scene::empty(121);
  scene.situation.velocity = scene.situation.last_command = driving;
  return scene;
}

// On each axis no larger than what the limit and the last command allow, and what a period may add or must take away.
void expect_bound(const Twist2& command, const Twist2& last, const Parameters& p, const std::string& what) {
  const double v = std::max({std::abs(last.v) - kStep, 0.0}), omega = std::max(std::abs(last.omega) - kTurn, 0.0);
  EXPECT_LE(command.v, std::max(p.max_vel_x, v) + 1e-9) << what;
  EXPECT_GE(command.v, std::min(p.min_vel_x, -v) - 1e-9) << what;
  EXPECT_LE(std::abs(command.omega), std::max(p.max_vel_theta, omega) + 1e-9) << what;
}

TEST(ImpossibleOdometry, AtRestItStartsNoCommand) {
  for (const Twist2& reading : kImpossible) {
    PlannerBench bench(on_a_plan());
    bench.drive();
    bench.scene().situation.velocity = reading;
    const Twist2 last = bench.scene().situation.last_command;
    const Decision& decision = bench.cycle();
    expect_bound(decision.command, last, bench.planner().parameters(), "autonomy");
    EXPECT_LE(std::abs(decision.command.v - last.v), kStep + 1e-9);
    EXPECT_LE(std::abs(decision.command.omega - last.omega), kTurn + 1e-9);
    EXPECT_TRUE(decision.odometry_doubted);
    // What is not believed counts as the last command.
    EXPECT_EQ(decision.velocity.v, reading.v != 0.0 ? last.v : 0.0);
    EXPECT_EQ(decision.velocity.omega, reading.omega != 0.0 ? last.omega : 0.0);
  }
}

TEST(ImpossibleOdometry, NorWhileSomebodyStopsTheRobot) {
  for (const Twist2& reading : kImpossible) {
    Scene scene = on_a_plan();
    scene.intent.influence = Influence::stop;
    PlannerBench bench(scene);
    bench.cycle();
    bench.scene().situation.time += kPeriod;
    bench.scene().situation.velocity = reading;
    const Decision& decision = bench.cycle();
    EXPECT_TRUE(decision.command == Twist2{}) << decision.command.v << " " << decision.command.omega;
    // Silence follows: what brakes then starts from what was sent.
    const FaultBrake::Command braking = FaultBrake().brake(1.0, reading, decision.command, bench.planner().parameters(),
                                                           bench.planner().limits(), kPeriod);
    EXPECT_TRUE(braking.command == Twist2{});
  }
}

TEST(ImpossibleOdometry, NorWithAPersonWhoSteersAloneOrOdometryAsTheReference) {
  Scene guarded = on_a_plan();
  guarded.steer({0.5, 0.3});
  guarded.intent.influence = Influence::direct;
  Scene unguarded = guarded, by_odometry = on_a_plan();
  unguarded.intent.guarded = false;
  by_odometry.parameters.method = Method::paper;
  for (Scene* scene : {&guarded, &unguarded, &by_odometry}) {
    for (const Twist2& reading : kImpossible) {
      scene->situation.velocity = reading;
      const Twist2 command = PlannerBench(*scene).cycle().command;
      EXPECT_LE(std::abs(command.v), kStep + 1e-9) << reading.v << " " << reading.omega;
      EXPECT_LE(std::abs(command.omega), kTurn + 1e-9) << reading.v << " " << reading.omega;
    }
  }
}

TEST(ImpossibleOdometry, WhileDrivingItIsAsIfItWereNotThere) {
  Scene scene = on_a_plan({0.3, 0.1});
  PlannerBench honest(scene);
  const Twist2 command = honest.cycle().command;
  scene.situation.velocity = {8.0, 0.1};
  PlannerBench bench(scene);
  EXPECT_TRUE(bench.cycle().command == command);
  EXPECT_TRUE(bench.planner().believed({8.0, 0.1}) == (Twist2{0.3, 0.1}));
  EXPECT_TRUE(bench.planner().believed({0.0, 0.1}) == (Twist2{0.3, 0.1}));  // 0.3 - 0.2 is more
  EXPECT_TRUE(bench.planner().believed({0.2, 0.1}) == (Twist2{0.2, 0.1}));
  EXPECT_TRUE(bench.planner().believed({std::nan(""), 0.1}) == (Twist2{0.3, 0.1}));
}

TEST(Limits, LoweredWhileItDrivesTheLastCommandIsReducedAtTheLimit) {
  Scene scene = on_a_plan({0.5, 0.8});
  PlannerBench bench(scene);
  bench.drive();
  Parameters lower = scene.parameters;
  lower.max_vel_x = 0.1;
  lower.max_vel_theta = 0.2;
  ASSERT_TRUE(bench.planner().configure(lower).empty());
  for (int k = 0; k < 8; ++k) {
    const Twist2 last = bench.scene().situation.last_command;
    bench.scene().situation.velocity = k % 2 > 0 ? Twist2{6.0, -9.0} : last;  // and now and then odometry is wrong
    const Twist2 command = bench.cycle().command;
    expect_bound(command, last, lower, std::to_string(k));
    bench.scene().situation.velocity = last;
    bench.scene().situation.last_command = command;
    bench.scene().situation.time += kPeriod;
  }
  EXPECT_LE(bench.scene().situation.last_command.v, 0.1 + 1e-9);
}

// A robot with its front `gap` [m] before a wall, which a person steers straight on.
Scene before_a_wall(double gap) {
  Scene scene = on_a_plan();
  scene.fill(1.025, -9.0, 9.0, 9.0);  // cells from x = 1.025 on
  scene.situation.pose = {1.025 - 0.2 - gap, 0.0, 0.0};
  scene.parameters.control_latency = 0.1;
  scene.parameters.sim_time = 0.1;  // rollouts are no matter
  scene.steer({0.5, 0.0});
  return scene;
}

// It rolls towards the wall, and nobody told it to.
TEST(FastOdometry, KeptForThreeTenthsOfASecondItCountsForCollisionsAndStartsNoCommand) {
  PlannerBench bench(before_a_wall(0.3));
  for (int k = 0; k < 8; ++k) {
    bench.scene().situation.velocity = {5.0, 0.0};
    const Decision& decision = bench.cycle();
    const bool believed = k * kPeriod >= 0.3 - 1e-9;
    EXPECT_EQ(decision.odometry_fast, believed) << k;
    EXPECT_EQ(decision.odometry_doubted, !believed) << k;
    EXPECT_EQ(decision.velocity.v, believed ? 5.0 : 0.0) << k;
    EXPECT_LE(decision.command.v, 0.125 + 1e-9) << k;  // the last command is 0
    // 0.1 s at 5 m/s is beyond the wall: nothing is legal any more.
    EXPECT_EQ(decision.outcome == Outcome::brake, believed) << k;
    EXPECT_TRUE(!believed || decision.command == Twist2{}) << k;
    bench.scene().situation.time += 1.0001 * kPeriod;
  }
}

// A robot that drives or turns as fast as it may, on and on, by an operator's wish.
Scene kept_at(const Twist2& u) {
  Scene scene = on_a_plan(u);
  scene.parameters.control_latency = 0.1;
  scene.steer(u);
  scene.intent.influence = Influence::direct;
  return scene;
}

// One cycle whose odometry reads `reading`; what it decides is sent.
Decision cycle_reading(PlannerBench& bench, const Twist2& reading) {
  bench.scene().situation.velocity = reading;
  Decision decision = bench.cycle();
  bench.scene().situation.last_command = decision.command;
  bench.scene().situation.time += kPeriod;
  return decision;
}

TEST(SlowOdometry, OneReadingStartsNoCommand) {
  for (const auto& [kept, reading] : {std::pair<Twist2, Twist2>{{0.5, 0.0}, {0.0, 0.0}}, {{0.0, 0.6}, {0.0, -0.49}}}) {
    PlannerBench bench(kept_at(kept));
    for (int k = 0; k < 5; ++k) cycle_reading(bench, kept);
    for (int k = 0; k < 20; ++k) {
      const bool wrong = k % 3 > 0;  // two in a row
      const Decision decision = cycle_reading(bench, wrong ? reading : kept);
      EXPECT_NEAR(decision.command.v, kept.v, 1e-9) << k;
      EXPECT_NEAR(decision.command.omega, kept.omega, 1e-9) << k;
      EXPECT_EQ(decision.odometry_doubted, wrong) << k;
      EXPECT_EQ(decision.velocity, kept) << k;
    }
  }
}

// A wall holds it. Commands fall from 0.5 m/s by 2.5 x 0.05 a period to what could have started from rest, 0.125 m/s.
// Rest is within the tolerance of that, 0.2 m/s: then they rise again.
TEST(SlowOdometry, FromTheThirdReadingOnCommandsFallAtTheLimit) {
  PlannerBench bench(kept_at({0.5, 0.0}));
  for (int k = 0; k < 5; ++k) cycle_reading(bench, {0.5, 0.0});
  double last = 0.5;
  for (const double expected : {0.5, 0.5, 0.375, 0.25, 0.125, 0.25}) {
    const Decision decision = cycle_reading(bench, {0.0, 0.0});
    EXPECT_NEAR(decision.command.v, expected, 1e-9);
    last = decision.command.v;
  }
  for (int k = 0; k < 100; ++k) {  // and so it goes on, whether it is held or let go
    const double v = cycle_reading(bench, {k % 20 < 10 ? 0.0 : last, 0.0}).command.v;
    EXPECT_LE(std::abs(v - last), kStep + 1e-9) << k;
    last = v;
  }
}

// Odometry is true. A late cycle brakes by two periods' worth, 0.25 m/s, which the base has not done when the next
// command takes effect.
TEST(LateCycles, WhatABaseHasNotReachedYetStartsNoCommand) {
  Scene scene = kept_at({0.5, 0.0});
  scene.situation.longest_period = 0.1;
  PlannerBench bench(scene);
  for (int k = 0; k < 5; ++k) cycle_reading(bench, {0.5, 0.0});
  bench.scene().situation.time += kPeriod;
  bench.scene().intent.influence = Influence::stop;
  EXPECT_NEAR(cycle_reading(bench, {0.5, 0.0}).command.v, 0.25, 1e-9);
  bench.scene().intent.influence = Influence::direct;
  EXPECT_NEAR(cycle_reading(bench, {0.5, 0.0}).command.v, 0.25 + kStep, 1e-9);
}

// Three commands of `step`, 2 `step` and 3 `step` [m/s] are under way, and odometry shows none of them yet.
Outcome outcome_near_a_wall(double step, Method method) {
  Scene scene = before_a_wall(0.02);
  scene.intent.influence = Influence::direct;
  scene.parameters.method = method;
  PlannerBench bench(scene);
  for (int k = 0; k < 3; ++k) {
    bench.cycle();
    bench.scene().situation.time += kPeriod;
    bench.scene().situation.last_command.v += step;
  }
  return bench.cycle().outcome;
}

TEST(OdometryAsTheReference, PendingMotionIsReckonedWith) {
  for (const Method method : {Method::paper, Method::hidwa}) {
    // From rest to 0.125 m/s and back: 0.05 * 0.0625 + 0.05 * 0.0625 m and the tail, 7 mm.
    EXPECT_EQ(outcome_near_a_wall(0.0, method), Outcome::drive);
    // From rest to 0.125 and 0.25 m/s in 0.1 s, and back: 0.05 * (0.0625 + 0.1875) + 0.25^2 / 5 = 25 mm.
    EXPECT_EQ(outcome_near_a_wall(0.125, method), Outcome::brake);
  }
}

TEST(Resumed, WhatWasSentBeforeThePauseIsForgotten) {
  Scene scene = on_a_plan({0.5, 0.0});
  PlannerBench bench(scene);
  for (int k = 0; k < 4; ++k) bench.drive();
  Situation& s = bench.scene().situation;
  s.time += 2.0;
  s.resumed = true;
  s.last_command = s.velocity = {0.2, 0.3};  // another node drove
  const Decision& decision = bench.cycle();
  EXPECT_EQ(decision.reference.v, 0.2);
  EXPECT_EQ(decision.reference.omega, 0.3);
  EXPECT_FALSE(decision.odometry_doubted);
}

TEST(PoseAge, TheCommandsSinceThenLeadOn) {
  // Round a curve: 0.1 m and 0.1 rad in 0.2 s, sin(0.1) and 1 - cos(0.1) on a circle of 1 m.
  Scene scene = on_a_plan({0.5, 0.5});
  scene.situation.pose_age = 0.2;
  const Pose2 pose = PlannerBench(scene).cycle().pose;
  EXPECT_NEAR(pose.x, std::sin(0.1), 1e-5);
  EXPECT_NEAR(pose.y, 1.0 - std::cos(0.1), 1e-5);
  EXPECT_NEAR(pose.theta, 0.1, 1e-9);
}

TEST(PoseAge, WhereOdometryIsSlowerForGoodItLeadsOnAsThatSays) {
  Scene scene = on_a_plan();
  scene.situation.last_command = {0.5, 0.0};
  scene.situation.pose_age = 0.05;
  PlannerBench bench(scene);
  for (const double led_on : {0.025, 0.025, 0.0}) {  // 0.5 * 0.05, until three readings agree
    bench.scene().situation.velocity = {0.0, 0.0};
    EXPECT_NEAR(bench.cycle().pose.x, led_on, 1e-9);
    bench.scene().situation.time += kPeriod;
  }
}

TEST(LateCycles, ALateBrakeTakesAsMuchAsTwoOnTime) {
  Scene scene = on_a_plan({0.5, 0.0});
  scene.situation.longest_period = 0.1;
  scene.intent.influence = Influence::stop;
  PlannerBench bench(scene);
  bench.cycle();
  bench.scene().situation.time += 0.08;
  EXPECT_NEAR(bench.cycle().command.v, 0.5 - 2.5 * 0.08, 1e-9);
  bench.scene().situation.time += 0.4;  // no later than the longest period is reckoned with
  EXPECT_NEAR(bench.cycle().command.v, 0.5 - 2.5 * 0.1, 1e-9);
}

}  // namespace
}  // namespace hidwa_local_planner
