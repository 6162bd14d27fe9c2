// SPDX-License-Identifier: BSD-3-Clause
#include "control/control_loop.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "hidwa_local_planner/critics/built_in.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::control {
namespace {

constexpr double kPeriod = 0.05;  // [s]

/// From x = 0 to `length` [m] along x, a pose every 0.1 m.
std::vector<Pose2> straight(double length, double goal_yaw = 0.0) {
  std::vector<Pose2> plan;
  const int steps = static_cast<int>(std::lround(length / 0.1));
  for (int i = 0; i <= steps; ++i) plan.push_back({0.1 * i, 0.0, i == steps ? goal_yaw : 0.0});
  return plan;
}

/// A loop in an empty map whose robot does what it is told, with an operator who wants what the test says.
class Bench {
 public:
  Bench() : scene_(test::Scene::empty(121)), loop_(critics::built_in()) {
    set(scene_.parameters);
    loop_.set_footprint(scene_.outline);
    seen_.timing = {10.0, kPeriod, kPeriod, kPeriod, false};
    seen_.velocity = Twist2{};
    seen_.costmap = scene_.grid();
  }
  void plan(std::vector<Pose2> poses, const std::string& frame = "map") {
    loop_.set_plan(std::move(poses), frame, seen_.timing.now, kPeriod);
  }
  Result step() {
    const Result result = loop_.step(seen_, intent_);
    seen_.timing.now += kPeriod;
    seen_.velocity = result.command;
    seen_.resumed.reset();
    return result;
  }
  Result steps(int count) {
    for (int k = 1; k < count; ++k) step();
    return step();
  }
  void wants(OperatorStateId state, Influence influence, const Twist2& u_h) {
    intent_.state = state;
    intent_.influence = influence;
    intent_.u_h = u_h;
  }
  void set(const Parameters& wanted) { EXPECT_TRUE(loop_.configure(wanted).empty()); }
  void pillar(double x, double y) { scene_.fill(x - 0.2, y - 0.2, x + 0.2, y + 0.2); }
  OperatorIntent& intent() { return intent_; }
  ControlLoop& loop() { return loop_; }
  Observation& seen() { return seen_; }
  const Parameters& parameters() const { return scene_.parameters; }

 private:
  test::Scene scene_;
  OperatorIntent intent_;
  ControlLoop loop_;
  Observation seen_;
};

TEST(ControlLoop, DrivesAlongItsPlanAndSaysWhatBecameOfIt) {
  Bench bench;
  EXPECT_FALSE(bench.loop().has_plan());
  bench.plan(straight(2.5));
  EXPECT_TRUE(bench.loop().has_plan());
  const Result result = bench.steps(6);
  EXPECT_EQ(result.outcome, Outcome::drive);
  EXPECT_NEAR(result.command.v, 0.5, 1e-9);  // 6 periods of 2.5 m/s^2 are 0.75 m/s
  EXPECT_EQ(result.feedback.command, result.command);
  EXPECT_FALSE(result.feedback.stands);
  EXPECT_EQ(bench.loop().last_command(), result.command);
  EXPECT_FALSE(bench.loop().stands());
}

TEST(ControlLoop, ASetWithFaultsChangesNothing) {
  Bench bench;
  Parameters wanted = bench.parameters();
  wanted.s_omega = 123.0;
  bench.set(wanted);
  EXPECT_EQ(bench.loop().parameters().s_omega, 123.0);
  wanted.s_omega = 77.0;
  wanted.critics = "NoSuchCritic";
  EXPECT_FALSE(bench.loop().configure(wanted).empty());
  EXPECT_EQ(bench.loop().parameters().s_omega, 123.0);
}

TEST(ControlLoop, OnlyAChangedLastPoseIsANewGoal) {
  Bench bench;
  const auto begins = [&bench](std::vector<Pose2> plan, const std::string& frame = "map") {
    bench.plan(std::move(plan), frame);
    const bool is_new = bench.loop().goal_begins();
    bench.loop().step(bench.seen(), {});
    EXPECT_FALSE(bench.loop().goal_begins());
    return is_new;
  };
  EXPECT_TRUE(begins(straight(3.0)));
  EXPECT_FALSE(begins(straight(3.0)));
  std::vector<Pose2> shorter = straight(3.0);
  shorter.erase(shorter.begin(), shorter.begin() + 10);  // a plan made anew from further on
  EXPECT_FALSE(begins(shorter));
  EXPECT_FALSE(begins(straight(3.2)));  // within 0.25 m of where the goal was when it was new
  EXPECT_TRUE(begins(straight(3.3)));
  EXPECT_TRUE(begins(straight(3.0)));
  EXPECT_TRUE(begins(straight(3.3)));
  EXPECT_TRUE(begins(straight(3.3, 0.5)));
  EXPECT_TRUE(begins(straight(3.3, 0.5), "odom"));
  bench.loop().finish_goal(bench.seen().timing);
  EXPECT_TRUE(begins(straight(3.3, 0.5), "odom"));
  bench.loop().drop_plan(bench.seen().timing.now, kPeriod);
  EXPECT_FALSE(bench.loop().has_plan());
  EXPECT_FALSE(begins(straight(3.3, 0.5), "odom"));  // the same goal as before
  bench.step();
  bench.seen().timing.now += 1.0;  // a pause: somebody else may have moved the robot
  EXPECT_TRUE(begins(straight(3.3, 0.5), "odom"));
}

TEST(ControlLoop, TheWindowOfThePlanIsInTheCostmapsFrame) {
  Bench bench;
  bench.plan(straight(2.5));
  // The plan's frame lies at (1, -2) in the costmap's, turned left by 90 degrees: plan x is costmap y.
  bench.seen().from_plan = {{1.0, -2.0, M_PI / 2}};
  bench.seen().pose = {1.0, -1.0, M_PI / 2};  // at 1 m of the plan
  bench.step();
  const Situation& situation = bench.loop().situation();
  ASSERT_FALSE(situation.plan.empty());
  EXPECT_NEAR(situation.plan.front().x, 1.0, 1e-9);
  EXPECT_NEAR(situation.plan.front().y, -2.0, 0.1 + 1e-9);  // 1 m behind
  EXPECT_NEAR(situation.plan.back().y, 0.5, 1e-9);
  EXPECT_NEAR(situation.plan.back().theta, M_PI / 2, 1e-9);
  EXPECT_NEAR(situation.goal.y, 0.5, 1e-9);
}

TEST(ControlLoop, TheWindowReachesAsFarAheadAsTheParametersAndTheMethodSay) {
  const auto last_pose = [](Method method) {
    Bench bench;
    Parameters wanted = bench.parameters();
    wanted.method = method;
    wanted.forward_prune_distance = 0.5;
    wanted.max_vel_x = 0.5;
    wanted.sim_time = 2.0;
    bench.set(wanted);
    bench.plan(straight(2.5));
    bench.step();
    return bench.loop().situation().plan.back().x;
  };
  EXPECT_NEAR(last_pose(Method::paper), 0.5, 1e-9);
  EXPECT_NEAR(last_pose(Method::hidwa), 1.2, 1e-9);  // 1.2 x 0.5 m/s x 2 s
}

// From (0, 0) by way of (1.2, y) to (2.4, 0), a pose every 0.1 m of x.
std::vector<Pose2> round_by(double y) {
  std::vector<Pose2> plan;
  for (int k = 0; k <= 24; ++k) plan.push_back({0.1 * k, y * (1.0 - std::abs(k - 12) / 12.0), 0.0});
  return plan;
}

// A host plans round the pillar on the left, then on the right, which is as long: 2 x hypot(1.2, 0.9) = 3 m.
TEST(ControlLoop, APlanRoundTheOtherSideWaitsWhileAutonomyDrives) {
  Bench bench;
  bench.pillar(1.2, 0.0);
  const auto side = [&bench] { return bench.loop().plan()[12].y; };
  bench.plan(round_by(0.9));
  bench.step();
  bench.plan(round_by(-0.9));
  for (int k = 0; k < 60; ++k) {  // 60 x 0.05 s = 3 s = plan_hysteresis_time, the first of them at 0 s
    bench.step();
    ASSERT_EQ(side(), 0.9) << k;
  }
  bench.steps(2);
  EXPECT_EQ(side(), -0.9);

  bench.plan(round_by(0.9));
  bench.step();
  EXPECT_EQ(side(), -0.9);
  bench.plan(round_by(-0.8));  // on this side: at once, and what waited is forgotten
  EXPECT_EQ(side(), -0.8);
  bench.step();
  EXPECT_EQ(side(), -0.8);

  bench.plan(round_by(0.9));
  bench.wants(OperatorStateId::shared, Influence::shared, {});
  bench.step();
  EXPECT_EQ(side(), 0.9);  // who steers chooses the side
  bench.plan(round_by(-0.9));
  EXPECT_EQ(side(), -0.9);
}

TEST(ControlLoop, WhereSomethingIsMissingItBrakes) {
  Bench bench;
  bench.plan(straight(2.5));
  bench.steps(6);
  bench.seen().fault = "no scan";
  Result result = bench.step();
  EXPECT_EQ(result.decision, nullptr);
  EXPECT_EQ(result.outcome, Outcome::brake);
  EXPECT_NEAR(result.command.v, 0.5 - 2.5 * kPeriod, 1e-9);
  // Four periods to rest; a late cycle brakes for the time since the one before.
  bench.seen().timing.interval = bench.seen().timing.longest_period = 2.0 * kPeriod;
  EXPECT_NEAR(bench.step().command.v, 0.5 - 3.0 * 2.5 * kPeriod, 1e-9);
  result = bench.steps(2);
  EXPECT_EQ(result.outcome, Outcome::fail);
  EXPECT_EQ(result.command, Twist2{});
  EXPECT_TRUE(bench.loop().stands());
}

// A cycle without a fault, whose pose is two periods old: how far the commands since then lead on [m].
double led_on(Bench& bench) {
  bench.seen().fault.clear();
  bench.seen().pose_age = 2.0 * kPeriod;
  const Result result = bench.step();
  EXPECT_NE(result.decision, nullptr);
  return result.decision->pose.x - bench.seen().pose.x;
}

// A base without latency that drives at 0.5 m/s.
void drive_without_latency(Bench& bench) {
  Parameters wanted = bench.parameters();
  wanted.control_latency = 0.0;
  bench.set(wanted);
  bench.plan(straight(2.5));
  bench.steps(8);
  ASSERT_NEAR(bench.loop().last_command().v, 0.5, 1e-9);
}

TEST(ControlLoop, WhatWasSentWhileAnInputWasMissingStillActs) {
  Bench bench;
  drive_without_latency(bench);
  bench.seen().fault = "no scan";
  bench.steps(2);  // 0.375 m/s, 0.25 m/s
  // Evenly from 0.5 to 0.375 to 0.25 m/s: 0.05 x (0.4375 + 0.3125) m.
  EXPECT_NEAR(led_on(bench), 0.0375, 1e-9);
}

TEST(ControlLoop, WhatWasSentAfterAPauseWhileAnInputWasMissingStillActs) {
  Bench bench;
  drive_without_latency(bench);
  bench.seen().timing.now += 1.0;
  bench.seen().resumed = Twist2{0.4, 0.0};  // another node drove
  bench.seen().fault = "no scan";
  bench.steps(2);  // 0.275 m/s, 0.15 m/s
  EXPECT_NEAR(led_on(bench), 0.05 * (0.3375 + 0.2125), 1e-9);
}

TEST(ControlLoop, TheZeroAtTheGoalActsFromThenOn) {
  Bench bench;
  drive_without_latency(bench);  // the last of these was sent a period ago
  bench.loop().finish_goal(bench.seen().timing);
  bench.seen().timing.now += kPeriod;
  bench.plan(straight(2.0));
  // At 0.5 m/s, then a period of braking at the limit, 0.125 m/s.
  EXPECT_NEAR(led_on(bench), 0.05 * (0.5 + 0.4375), 1e-9);
}

TEST(ControlLoop, WhatWasSentBeforeAClockWasSetBackStillActs) {
  Bench bench;
  drive_without_latency(bench);
  bench.seen().host_stops = true;
  bench.steps(2);  // 0.375 m/s, 0.25 m/s
  bench.seen().timing.now -= 50.0;
  bench.seen().timing.jumped_back = true;
  EXPECT_NEAR(led_on(bench), 0.0375, 1e-9);  // as above
}

// What a late cycle may brake counts from the cycle before, also where that had a fault.
TEST(ControlLoop, TheFirstCycleAfterAFaultBrakesByOnePeriod) {
  Bench bench;
  drive_without_latency(bench);
  bench.seen().timing.longest_period = 3.0 * kPeriod;
  bench.seen().fault = "no scan";
  bench.step();
  bench.seen().fault.clear();
  bench.seen().host_stops = true;
  EXPECT_NEAR(bench.step().command.v, 0.5 - 2.0 * 2.5 * kPeriod, 1e-9);
}

TEST(ControlLoop, TheHostStopsTheRobotWhateverTheOperatorWants) {
  Bench bench;
  bench.plan(straight(2.5));
  bench.steps(6);
  bench.wants(OperatorStateId::shared, Influence::shared, {0.5, 0.3});
  bench.seen().host_stops = true;
  const Result result = bench.step();
  ASSERT_NE(result.decision, nullptr);
  EXPECT_NEAR(result.command.v, 0.5 - 2.5 * kPeriod, 1e-9);
  EXPECT_EQ(result.intent.influence, Influence::shared);  // what the operator wants stays what they want
}

TEST(ControlLoop, AfterThePauseOfAHostItStartsFromWhatTheRobotDoes) {
  Bench bench;
  bench.plan(straight(2.5));
  bench.seen().velocity = Twist2{0.3, 0.0};
  bench.seen().resumed = Twist2{0.3, 0.0};
  EXPECT_NEAR(bench.step().command.v, 0.3 + 2.5 * kPeriod, 1e-9);
  EXPECT_TRUE(bench.loop().situation().resumed);
  bench.step();
  EXPECT_FALSE(bench.loop().situation().resumed);
  bench.seen().resumed = Twist2{5.0, 0.0};  // beyond the limit
  bench.step();
  EXPECT_EQ(bench.loop().situation().last_command.v, bench.parameters().max_vel_x);
}

TEST(ControlLoop, TheGoalIsReachedWhereTheRobotStandsAtIt) {
  Bench bench;
  bench.plan(straight(1.0));
  EXPECT_FALSE(bench.loop().goal_reached(bench.seen(), false));
  bench.seen().pose = {0.9, 0.0, 0.0};
  EXPECT_TRUE(bench.loop().goal_reached(bench.seen(), false));
  EXPECT_FALSE(bench.loop().goal_reached(bench.seen(), true));
  bench.seen().fault = "no odometry";
  bench.seen().velocity.reset();
  EXPECT_FALSE(bench.loop().goal_reached(bench.seen(), false));
}

// One cycle of `bench`, which decides the same, to the bit, for a twin that loads what the bench saved before.
Result step_as_a_twin(Bench& bench, Bench& twin) {
  Bytes state;
  bench.loop().save(state);
  EXPECT_TRUE(twin.loop().load(state));
  twin.seen() = bench.seen();
  const Result a = bench.step(), b = twin.step();
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_TRUE(a.command == b.command);
  EXPECT_EQ(bench.loop().situation().plan.size(), twin.loop().situation().plan.size());
  EXPECT_EQ(a.feedback.goal_latched, b.feedback.goal_latched);
  return a;
}

// Through a plan's progress, a brake, a pause and a goal.
TEST(ControlLoop, WhatItRemembersCanBeSavedAndLoaded) {
  Bench bench, twin;
  bench.plan(straight(1.5));
  twin.plan(straight(1.5));
  bool latched = false;
  for (int k = 0; k < 80; ++k) {
    SCOPED_TRACE(k);
    if (k == 10) bench.seen().fault = "no scan";
    if (k == 12) bench.seen().fault.clear();
    if (k == 20) bench.seen().resumed = Twist2{0.1, 0.0};
    latched = step_as_a_twin(bench, twin).feedback.goal_latched;
    bench.seen().pose.x += kPeriod * bench.seen().velocity->v;
  }
  EXPECT_TRUE(latched);
  Bytes state;
  bench.loop().save(state);
  for (std::size_t n = 0; n < state.size(); ++n) {
    EXPECT_FALSE(twin.loop().load(Bytes(state.begin(), state.begin() + static_cast<std::ptrdiff_t>(n)))) << n;
  }
}

TEST(ControlLoop, WhoeverIsCarriedAwayFromTheGoalBeginsAfresh) {
  Bench bench;
  bench.plan(straight(1.0));
  bench.seen().pose = {0.9, 0.0, 0.0};
  input::CycleFeedback said = bench.step().feedback;
  EXPECT_TRUE(said.goal_latched);
  EXPECT_FALSE(said.new_goal);
  bench.seen().pose = {0.0, 0.5, 0.0};
  said = bench.step().feedback;
  EXPECT_FALSE(said.goal_latched);
  EXPECT_TRUE(said.new_goal);
  EXPECT_FALSE(bench.loop().goal_begins());  // it was said already

  bench.seen().pose = {0.9, 0.0, 0.0};
  bench.step();
  bench.seen().pose = {0.0, 0.5, 0.0};
  EXPECT_FALSE(bench.loop().goal_reached(bench.seen(), false));
  EXPECT_TRUE(bench.loop().goal_begins());  // between two cycles
}

// Without a goal the operator drives; what they let go of brakes to rest, within the limits.
TEST(ControlLoopWithoutGoal, TheOperatorDrivesAndTheirReleaseBrakes) {
  Bench bench;
  bench.seen().goalless = true;
  bench.wants(OperatorStateId::manual, Influence::direct, {0.4, 0.0});
  const Result result = bench.steps(20);
  EXPECT_NEAR(result.command.v, 0.4, 1e-9);
  EXPECT_TRUE(result.goalless);
  bench.intent() = {};
  // 2.5 m/s^2 takes 0.4 m/s away in 0.16 s: in four cycles of 0.05 s.
  for (const double v : {0.275, 0.15, 0.025, 0.0}) EXPECT_NEAR(bench.step().command.v, v, 1e-9);
  EXPECT_EQ(bench.step().outcome, Outcome::hold);
}

// A cycle that would pass the command through with a goal is guarded without one.
TEST(ControlLoopWithoutGoal, SharedAndUnguardedCommandsAreGuardedAndDirect) {
  for (const Influence influence : {Influence::shared, Influence::direct}) {
    Bench bench;
    bench.pillar(0.8, 0.0);
    bench.seen().goalless = true;
    bench.wants(OperatorStateId::manual, influence, {0.5, 0.0});
    bench.intent().guarded = false;
    for (int k = 0; k < 40; ++k) {
      const Result result = bench.step();
      bench.seen().pose.x += kPeriod * result.command.v;  // straight on, as far as it is let
      ASSERT_LT(bench.seen().pose.x, 0.4);                // the pillar begins at 0.6 m, the robot's front is at 0.2 m
    }
  }
}

TEST(ControlLoopWithoutGoal, AGoalTakesOverWithoutAJumpAndIsANewOne) {
  Bench bench;
  bench.plan(straight(2.5));
  bench.step();
  bench.seen().goalless = true;
  bench.wants(OperatorStateId::manual, Influence::direct, {0.5, 0.0});
  Twist2 last = bench.steps(20).command;
  bench.seen().goalless = false;
  bench.intent() = {};
  bench.plan(straight(2.5));  // the same goal as before: it begins anew
  EXPECT_TRUE(bench.loop().goal_begins());
  for (int k = 0; k < 10; ++k) {
    const Twist2 next = bench.step().command;
    EXPECT_LE(std::abs(next.v - last.v), bench.parameters().acc_lim_x * kPeriod + 1e-9);
    EXPECT_LE(std::abs(next.omega - last.omega), bench.parameters().acc_lim_theta * kPeriod + 1e-9);
    last = next;
  }
}

// The state saved in the middle of a way round a pillar decides the next cycles alike, to the bit.
TEST(ControlLoopWithoutGoal, WhatIsRememberedRepeatsACycle) {
  Bench bench, other;
  for (Bench* one : {&bench, &other}) {
    one->pillar(1.4, 0.25);
    one->seen().goalless = true;
    one->wants(OperatorStateId::manual, Influence::direct, {0.5, 0.0});
  }
  bool turned = false;
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    const Twist2 command = step_as_a_twin(bench, other).command;
    turned = turned || command.omega != 0.0;
    Pose2& pose = bench.seen().pose;
    pose.theta += kPeriod * command.omega;
    pose.x += kPeriod * command.v * std::cos(pose.theta);
    pose.y += kPeriod * command.v * std::sin(pose.theta);
  }
  EXPECT_TRUE(turned);
  EXPECT_GT(bench.seen().pose.x, 1.0);
}

}  // namespace
}  // namespace hidwa_local_planner::control
