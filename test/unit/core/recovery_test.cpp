// SPDX-License-Identifier: BSD-3-Clause
// Places where autonomy stands still, though a way leads on.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/util/archive.hpp"
#include "support/effort.hpp"
#include "support/naive_inflation.hpp"
#include "support/naive_planner.hpp"
#include "support/planner_bench.hpp"
#include "support/round_outline.hpp"

namespace hidwa_local_planner {
namespace {

using test::mover_at;
using test::PlannerBench;
using test::Scene;

constexpr double kRadius = 0.31;  // [m]

// It drives along a way of its recovery.
bool drives_on_a_way(const Decision& decision) { return decision.recovering && !(decision.command == Twist2{}); }

// A robot at rest in an empty map.
Scene robot(const Polygon& outline, int cells = 81) {
  Scene scene = Scene::empty(cells, 0.05);
  scene.parameters = Parameters();
  scene.outline = outline;
  return scene;
}
Scene round_robot(int cells = 81) { return robot(test::round_outline(kRadius), cells); }

// For a round robot: 0.31 cos(pi / 16) is inscribed.
void inflate(Scene& scene) { test::inflate(scene, 0.304, 0.8, 3.0); }

// A plan along the x axis.
std::vector<Pose2> straight(double from, double to) {
  std::vector<Pose2> plan;
  for (int k = 0; from + 0.05 * k <= to + 1e-9; ++k) plan.push_back({from + 0.05 * k, 0.0, 0.0});
  return plan;
}

// A plan that passes a block on its right more closely than the robot may: the block begins `ahead` of the robot's
// centre, its upper edge lies at y = -0.275; robot and plan lie at y.
Scene beside_a_block(double ahead, double y) {
  Scene scene = round_robot();
  scene.fill(ahead, -1.0, ahead + 0.4, -0.275);
  inflate(scene);
  for (Pose2& pose : scene.situation.plan) pose.y = y;
  scene.situation.pose.y = scene.situation.goal.y = y;
  return scene;
}

double driven(const Scene& scene) {
  PlannerBench bench(scene);
  for (int k = 0; k < 200; ++k) {
    bench.drive();
    const Scene& now = bench.scene();
    // Where the centre's cell is inscribed it counts as in collision already and finds its way by coarser steps: a
    // disc 3 mm deep in an edge overlaps it by 4/3 d sqrt(2 R d) = 1.7e-4 m2.
    EXPECT_LT(test::naive_overlap(now.grid(), test::naive_body(now), now.situation.pose, true), 1.7e-4);
  }
  return bench.scene().situation.pose.x;
}

TEST(Recovery, PastCornersThatThePlanHugs) {
  int stuck_without = 0, scenes = 0;
  for (const double ahead : {0.125, 0.225, 0.325}) {
    for (double y = 0.0; y < 0.05; y += test::effort(0.024, 0.008)) {
      Scene scene = beside_a_block(ahead, y);
      const test::NaiveBody body = test::naive_body(scene);
      if (test::naive_overlap(scene.grid(), body, scene.situation.pose, true) > 0.0) continue;
      ++scenes;
      EXPECT_GT(driven(scene), 0.8) << ahead << " " << y;
      scene.parameters.method = Method::paper;
      if (driven(scene) < 0.8) ++stuck_without;
    }
  }
  EXPECT_GE(scenes, test::effort(4, 10));
  EXPECT_GE(stuck_without, test::effort(1, 3));  // or these scenes show nothing
}

// It faces a wall: nothing that drives is legal, and no turn is cheaper than standing before it is half done.
TEST(Recovery, TurnsFromAWallToThePlan) {
  for (const double theta : {M_PI, 2.5, -2.0, 1.2}) {
    Scene scene = round_robot();
    scene.situation.pose.theta = theta;
    const double x = (kRadius + 0.08) * std::cos(theta), y = (kRadius + 0.08) * std::sin(theta);
    scene.fill(x - 0.05, y - 0.05, x + 0.05, y + 0.05);
    EXPECT_GT(driven(scene), 0.8) << theta;
  }
}

// A cell that a new scan put into the robot's right side; a wall on the left leaves no room for an arc out of it.
TEST(Recovery, OutOfACollisionByTurningFirst) {
  Scene scene = round_robot();
  scene.situation.pose = {0.0, 0.006, -0.5};
  // Its upper edge at -0.275: 0.31 - 0.281 = 29 mm deep, more than the half cell that it could drive along.
  scene.fill(-0.05, -0.325, 0.05, -0.275);
  scene.fill(-1.0, 0.375, 1.0, 0.425);  // 0.375 - 0.006 - 0.31 = 59 mm beside it
  Scene stays = scene;
  stays.parameters.method = Method::paper;
  PlannerBench bench(scene), without(stays);
  const test::NaiveBody body = test::naive_body(scene);
  const auto overlap = [&body](PlannerBench& b) {
    return test::naive_overlap(b.scene().grid(), body, b.scene().situation.pose, true);
  };
  const double deep = overlap(bench);
  ASSERT_GT(deep, 0.0);
  for (int k = 0; k < 200 && overlap(bench) > 0.0; ++k) {
    bench.drive();
    EXPECT_LT(overlap(bench), deep + 5e-4);  // of 16 corners a turn moves some in, some out [m2]
  }
  EXPECT_LT(overlap(bench), 1e-9);
  for (int k = 0; k < 200; ++k) without.drive();
  EXPECT_GT(overlap(without), 0.0);  // or this scene shows nothing
}

// A square of walls around the origin, from `inner` to `outer` [m].
void wall_in(Scene& scene, double inner, double outer) {
  scene.fill(-outer, -outer, outer, -inner);
  scene.fill(-outer, inner, outer, outer);
  scene.fill(-outer, -outer, -inner, outer);
  scene.fill(inner, -outer, outer, outer);
}

// Walled in on all sides: standing is right, and the host is told.
TEST(Recovery, WhereThereIsNoneItSaysSo) {
  Scene scene = round_robot();
  wall_in(scene, 0.33, 0.6);
  PlannerBench bench(scene);
  int failures = 0;
  std::string problem;
  for (int k = 0; k < 400; ++k) {
    const Decision& decision = bench.drive();
    if (decision.outcome != Outcome::fail) continue;
    ++failures;
    problem = decision.problem;
  }
  EXPECT_GT(failures, 100);
  EXPECT_NE(problem.find("no way for this outline through the local map: no farther than ("), std::string::npos);
  EXPECT_NE(problem.find("nearest obstacle there 0.0"), std::string::npos);  // 0.33 - 0.31 m, to whole cells
  EXPECT_LT(std::hypot(bench.scene().situation.pose.x, bench.scene().situation.pose.y), 0.03);
}

// A corridor of 0.9 m, closed behind the robot; 0.4 m from its edge somebody stands in it, or a wall before him.
Scene in_a_corridor(double closed_at, bool walled = false) {
  Scene scene = round_robot();
  scene.fill(closed_at - 0.1, 0.45, 2.0, 0.6);
  scene.fill(closed_at - 0.1, -0.6, 2.0, -0.45);
  scene.fill(closed_at - 0.1, -0.6, closed_at, 0.6);
  if (walled) scene.fill(0.65, -0.6, 0.75, 0.6);
  inflate(scene);
  scene.situation.moving_obstacles = {mover_at(1.0, 0.0)};
  return scene;
}

// What came until a cycle failed; -1: none did.
struct Failure {
  int cycle = -1;
  std::string problem;
  bool waiting = false;
  int waited = 0, drove_on_a_way = 0;  // cycles
};
Failure first_failure(PlannerBench& bench, int cycles) {
  Failure failure;
  for (int k = 0; k < cycles; ++k) {
    const Decision& decision = bench.drive();
    failure.waited += decision.waiting;
    failure.drove_on_a_way += drives_on_a_way(decision);
    if (decision.outcome != Outcome::fail) continue;
    failure.cycle = k;
    failure.problem = decision.problem;
    failure.waiting = decision.waiting;
    break;
  }
  return failure;
}

// 30 s of waiting, 3 s for what leads there: 50 ms a cycle.
TEST(Recovery, WaitsForWhomBlocksTheOnlyWay) {
  PlannerBench bench(in_a_corridor(-0.5));
  const Failure failure = first_failure(bench, 800);
  EXPECT_GE(failure.cycle, 600);
  EXPECT_LE(failure.cycle, 660 + 40);  // it asks again every 2 s
  EXPECT_NE(failure.problem.find("what moves has blocked the only way"), std::string::npos) << failure.problem;
  EXPECT_GE(failure.waited, 590);
  EXPECT_FALSE(failure.waiting) << "it has given up";
  // He goes, and the way is free.
  bench.scene().situation.moving_obstacles.clear();
  for (int k = 0; k < 200; ++k) bench.drive();
  EXPECT_FALSE(bench.drive().waiting);
  EXPECT_GT(bench.scene().situation.pose.x, 0.9);
}

TEST(Recovery, DoesNotWaitWhereAWallIsInTheWayToo) {
  PlannerBench bench(in_a_corridor(-0.5, true));
  const Failure failure = first_failure(bench, 400);
  EXPECT_EQ(failure.waited, 0);
  EXPECT_GE(failure.cycle, 0);
  EXPECT_LE(failure.cycle, 160);  // the patience, two searches of much less than 8 s, and some cycles
}

// It comes along the corridor. 2.5 m ahead somebody stands in it.
Scene along_a_corridor(double step_back_after) {
  Scene scene = in_a_corridor(-1.9);
  scene.parameters.step_back_after = step_back_after;
  scene.situation.pose.x = -1.5;
  scene.situation.plan = straight(-1.5, 1.8);
  return scene;
}

// Where it has stood first, and how far it has come back from there until it has stood for 20 s in all [m].
struct SteppedBack {
  double stood_at = 0.0, by = 0.0;
};
SteppedBack stepped_back(PlannerBench& bench) {
  SteppedBack result;
  int stood = 0;
  for (int k = 0; k < 1200 && stood < 400; ++k) {
    const bool stands = bench.drive().command == Twist2{};
    const double x = bench.scene().situation.pose.x;
    if (stands && ++stood == 20) result.stood_at = x;
    if (stood >= 20) result.by = std::max(result.by, result.stood_at - x);
  }
  return result;
}

// They would wait for each other for ever.
TEST(Recovery, StepsBackForWhomItKeepsFromGettingOut) {
  PlannerBench bench(along_a_corridor(6.0));
  const SteppedBack stepped = stepped_back(bench);
  EXPECT_GT(stepped.stood_at, -0.5) << "it came near first";
  EXPECT_GT(stepped.by, 0.3);
  bench.scene().situation.moving_obstacles.clear();
  for (int k = 0; k < 300; ++k) bench.drive();
  EXPECT_GT(bench.scene().situation.pose.x, 1.0);
}

TEST(Recovery, DoesNotStepBackUnlessAsked) {
  PlannerBench bench(along_a_corridor(0.0));
  EXPECT_LT(stepped_back(bench).by, 0.05);
}

// What is behind him cannot be seen, and blocks the way on the map: the host is told that there is none, and the robot
// goes back all the same. Where only a wall is in the way it has no reason to.
TEST(Recovery, StepsBackThoughTheMapIsBlockedBehindHim) {
  Scene scene = along_a_corridor(1.0);
  scene.fill(1.4, -0.45, 1.5, 0.45);
  inflate(scene);
  PlannerBench blocked(scene);
  EXPECT_GT(stepped_back(blocked).by, 0.3);
  scene.situation.moving_obstacles.clear();
  PlannerBench walled(scene);
  EXPECT_LT(stepped_back(walled).by, 0.05);
}

// Once and again; then the host is told.
TEST(Recovery, DoesNotStepBackForEver) {
  PlannerBench bench(along_a_corridor(1.0));
  const Failure failure = first_failure(bench, 2400);
  EXPECT_GT(failure.drove_on_a_way, 20);
  EXPECT_GT(failure.cycle, 600);  // 30 s of waiting
}

// Two come along the corridor side by side, and never get there: autonomy stands for them, by choice where they are 2 m
// away, and because nothing else is legal where they are 0.1 m from its edge. 30 s of that are 600 cycles.
TEST(Recovery, IsNotStuckWhileItStandsForWhatMoves) {
  for (const double away : {2.0, 0.73}) {
    Scene scene = in_a_corridor(-0.5);
    scene.parameters.evasion_time = 3.0;
    scene.situation.moving_obstacles.resize(2, scene.situation.moving_obstacles.front());
    scene.situation.moving_obstacles.back().id = 2;
    PlannerBench bench(scene);
    int stood = 0, waited = 0, first = -1;
    for (int k = 0; k < 900 && first < 0; ++k) {
      Situation& s = bench.scene().situation;
      for (const int side : {0, 1}) {
        s.moving_obstacles[static_cast<std::size_t>(side)].position = {s.pose.x + away, side == 0 ? -0.15 : 0.15};
        s.moving_obstacles[static_cast<std::size_t>(side)].velocity = {-0.9, 0.0};
      }
      const Decision& decision = bench.drive();
      const bool stands = decision.command == Twist2{};
      stood = stands ? stood + 1 : 0;
      waited += stands && decision.waiting;
      if (decision.outcome == Outcome::fail) first = stood;
    }
    EXPECT_GE(first, 590) << away << ": it has stood so long when it first fails";
    EXPECT_LE(first, 700) << away;
    EXPECT_GE(waited, 500) << away;
  }
}

// A pen of 3 x 3 m that the plan leads out of: there is no way.
Scene in_a_pen() {
  Scene scene = round_robot();
  scene.parameters.evasion_time = 3.0;
  scene.situation.plan = straight(-1.0, 1.9);
  wall_in(scene, 1.5, 1.6);
  inflate(scene);
  return scene;
}

// Each cycle fails. Then somebody walks at the robot from behind, at this velocity.
Point have_somebody_walk_at(PlannerBench& bench) {
  int failures = 0;
  for (int k = 0; k < 800 && failures < 40; ++k) failures += bench.drive().outcome == Outcome::fail;
  EXPECT_EQ(failures, 40);
  Situation& s = bench.scene().situation;
  const Point ahead(std::cos(s.pose.theta), std::sin(s.pose.theta));
  const Point velocity = 0.6 * ahead;
  s.moving_obstacles = {mover_at(s.pose.x - 1.8 * ahead.x(), s.pose.y - 1.8 * ahead.y(), velocity.x(), velocity.y())};
  return velocity;
}

TEST(Recovery, DoesNotStopARobotThatEvades) {
  PlannerBench bench(in_a_pen());
  const Point velocity = have_somebody_walk_at(bench);
  const Situation& s = bench.scene().situation;
  int evades = 0;
  for (int k = 0; k < 60; ++k) {
    const Decision& decision = bench.drive();
    Point& at = bench.scene().situation.moving_obstacles.front().position;
    at += s.period * velocity;
    if (bench.planner().choice().rule != ChoiceReport::Rule::evasion) continue;
    ++evades;
    EXPECT_NE(decision.outcome, Outcome::fail) << k << ": " << decision.problem;
    EXPECT_GT((at - Point(s.pose.x, s.pose.y)).norm(), 0.6) << k;  // 0.3 m and 0.31 m, less 1 cm
  }
  EXPECT_GT(evades, 10);
}

// The robot follows a way out of a pen through a gap beside its plan, and the gap is closed. So it stands, and there is
// no way. Then somebody walks at it, and vanishes while it evades him. The host is told at rest that there is no way,
// not before: it would stop the robot at once.
TEST(Recovery, FailsAtRestOnly) {
  Scene scene = round_robot(141);
  scene.parameters.evasion_time = 3.0;
  for (double x = 1.05; x < 2.9; x += 0.05) scene.situation.plan.push_back({x, 0.0, 0.0});
  wall_in(scene, 2.4, 2.5);
  scene.fill(1.5, -2.5, 1.6, 2.5);
  scene.fill(1.5, 1.0, 1.6, 2.0, cost::kFree);
  inflate(scene);
  PlannerBench bench(scene);
  bool follows = false;
  for (int k = 0; k < 400 && !follows; ++k) {
    const Decision& decision = bench.drive();
    follows = drives_on_a_way(decision) && decision.command.v > 0.3;
  }
  ASSERT_TRUE(follows);
  bench.scene().fill(1.5, 1.0, 1.6, 2.0);
  inflate(bench.scene());
  const Point velocity = have_somebody_walk_at(bench);
  Situation& s = bench.scene().situation;
  int failures = 0;
  double fastest = 0.0;
  for (int k = 0; k < 400; ++k) {
    const Twist2 before = s.last_command;
    const Decision& decision = bench.drive();
    EXPECT_NEAR(s.last_command.v, before.v, 2.5 * 0.05 + 1e-9) << k << ": " << decision.problem;
    if (decision.outcome == Outcome::fail) {
      EXPECT_EQ(before, Twist2{}) << k << ": " << decision.problem;
      ++failures;
    }
    if (s.moving_obstacles.empty()) continue;
    fastest = std::max(fastest, s.last_command.v);
    s.moving_obstacles.front().position += s.period * velocity;
    if (s.last_command.v > 0.3) s.moving_obstacles.clear();
  }
  EXPECT_GT(fastest, 0.3) << "it has evaded";
  EXPECT_GT(failures, 0);
}

// A rectangle that is long ahead of its centre and faces away from the plan. What stands on its right is 0.35 m away,
// and its front 0.5 m long: it can only turn left, which is the longer way.
Scene beside_a_thing() {
  Scene scene = robot({{0.5, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.5, -0.2}});
  scene.parameters.search_poses = 500;  // so that it takes some cycles
  scene.situation.pose.theta = 2.8;
  scene.fill(-0.2, 0.35, 0.2, 0.45);
  test::inflate(scene, 0.2, 0.55, 3.0);
  return scene;
}

TEST(Recovery, TurnsTheLongWayRound) {
  Scene scene = beside_a_thing();
  EXPECT_GT(driven(scene), 0.5);
  scene.parameters.method = Method::paper;
  EXPECT_LT(driven(scene), 0.1);  // or this scene shows nothing
}

// In a pocket it faces the wall behind it.
Scene in_a_pocket() {
  Scene scene = robot({{0.35, 0.2}, {-0.35, 0.2}, {-0.35, -0.2}, {0.35, -0.2}});
  scene.situation.pose.theta = 3.1;
  scene.fill(-0.5, 0.45, 1.0, 0.55);
  scene.fill(-0.5, -0.55, 1.0, -0.45);
  scene.fill(-0.6, -0.55, -0.5, 0.55);
  test::inflate(scene, 0.2, 0.55, 3.0);
  return scene;
}

// With few poses a cycle the search takes longer than the 1.2 s after which the robot says so: once the host is told,
// the search goes on, and the way is taken. A host that begins afresh after the failure, since it took its time for
// another plan, is not told again: the second search has the time that it takes.
TEST(Recovery, SaysOnceThatItTakesLongAndGoesOnSearching) {
  for (const bool begins_afresh : {false, true}) {
    Scene scene = in_a_pocket();
    scene.parameters.search_poses = 10;
    PlannerBench bench(scene);
    int failed = -1, drives = -1;
    for (int k = 0; k < 400 && drives < 0; ++k) {
      const Decision& decision = bench.drive();
      if (drives_on_a_way(decision)) drives = k;
      if (decision.outcome != Outcome::fail) continue;
      EXPECT_EQ(failed, -1) << "told again in cycle " << k;
      EXPECT_NE(decision.problem.find("no way was found in time"), std::string::npos) << decision.problem;
      failed = k;
      if (begins_afresh) bench.planner().reset();
    }
    // The search begins when it has stood for the latency of 0.1 s and two cycles of 0.05 s: 1.4 s in all.
    EXPECT_GE(failed, 26);
    EXPECT_LE(failed, 30);
    EXPECT_GT(drives, begins_afresh ? 60 : failed + 10);
  }
}

// While it searches the plan comes to lead elsewhere: the way that is found leads to where the plan was, and is not
// taken.
TEST(Recovery, TakesNoWayToAnOldPlan) {
  Scene scene = in_a_pocket();
  scene.fill(-2.1, -2.1, -0.6, 2.1);
  scene.parameters.search_poses = 10;
  PlannerBench bench(scene);
  for (int k = 0; k < 10; ++k) bench.drive();
  std::vector<Pose2>& plan = bench.scene().situation.plan;
  plan.clear();
  for (int i = 0; i < 36; ++i) plan.push_back({-0.05 * i, 0.0, M_PI});  // ahead of it, into the wall
  bench.scene().situation.goal = plan.back();
  bool failed = false;
  for (int k = 0; k < 800 && !failed; ++k) {
    const Decision& decision = bench.drive();
    EXPECT_LT(bench.scene().situation.pose.x, 0.3);
    failed = decision.outcome == Outcome::fail && bench.scene().situation.time > 20.0;
  }
  EXPECT_TRUE(failed) << "it finds that there is none";
}

// Its wheels slip: of what is commanded it does that share. For how long it follows its way before it stands [s]; 5
// where it does not within 5 s.
double follows_with_slip(double share) {
  PlannerBench bench(beside_a_thing());
  for (int k = 0, follows = 0; k < 200 && follows < 5; ++k) {
    const Decision& decision = bench.drive();
    follows = drives_on_a_way(decision) ? follows + 1 : 0;
  }
  Situation& s = bench.scene().situation;
  const double began = s.time;
  while (s.time < began + 5.0) {
    const Decision& decision = bench.cycle();
    EXPECT_TRUE(decision.recovering);
    if (decision.command == Twist2{}) return s.time - began;
    s.last_command = s.velocity = decision.command;
    s.pose.x += share * decision.command.v * std::cos(s.pose.theta) * s.period;
    s.pose.y += share * decision.command.v * std::sin(s.pose.theta) * s.period;
    s.pose.theta += share * decision.command.omega * s.period;
    s.time += s.period;
  }
  return 5.0;
}

// The remaining time must fall by 0.05 s within 1 s: with 3.5 % of the motion it falls by 0.035 s.
TEST(Recovery, StandsWhereItDoesNotGetOnAlongItsWay) {
  for (const double share : {0.0, 0.035}) {
    const double time = follows_with_slip(share);
    EXPECT_GE(time, 0.9) << share;
    EXPECT_LE(time, 2.5) << share;  // and braking to rest
  }
  EXPECT_GT(follows_with_slip(0.5), 2.5);
}

// A corridor 0.75 m wide, its way in the middle. 0.6 m before it, a cell is marked that the way passes 1 cm away. Where
// a new way ends, another 2.5 m on, does not speak against it: the robot keeps to the other side. Beside the cell it
// has 0.04 m to share on its left.
TEST(Recovery, KeepsAwayFromACellNearTheEndOfItsWay) {
  Scene scene = round_robot(161);
  scene.situation.plan = straight(-1.0, 3.75);
  scene.fill(0.3, -3.9, 3.5, -0.36);
  scene.fill(0.3, 0.36, 3.5, 3.9);
  Scene marked = scene;
  marked.fill(1.9, -0.36, 1.95, -0.32);
  for (Scene* one : {&scene, &marked}) inflate(*one);
  PlannerBench bench(scene);
  const Pose2& pose = bench.scene().situation.pose;
  bool followed = false;
  for (int k = 0; k < 100 && pose.x < 1.9; ++k) {
    if (pose.x > 1.3 && bench.scene().costs != marked.costs) bench.scene().costs = marked.costs;
    followed = drives_on_a_way(bench.drive()) || followed;
  }
  EXPECT_TRUE(followed);
  EXPECT_GE(pose.x, 1.9);
  EXPECT_GT(pose.y, 0.01);
}

// In a pocket whose way out waits for the patience. The robot is not where an empty state would have it.
Scene patient_in_a_pocket() {
  Scene scene = in_a_pocket();
  scene.situation.pose.x = 0.2;
  scene.parameters.stall_time = 3.0;
  scene.parameters.search_poses = 20;
  return scene;
}

Scene walled_in_beside_a_thing() {
  Scene scene = beside_a_thing();
  wall_in(scene, 0.9, 1.1);
  return scene;
}

// Within 0.25 m of its goal, with a tail of 0.9 m between posts: see test/closed_loop/last_turn_test.cpp.
Scene at_its_last_turn() {
  Scene scene = robot({{0.2, 0.2}, {-0.9, 0.2}, {-0.9, -0.2}, {0.2, -0.2}});
  scene.situation.pose = {-0.23, 0.0, 0.0};
  scene.situation.goal = {0.0, 0.0, 0.5 * M_PI};
  scene.situation.goal_latched = true;
  scene.fill(-1.05, -0.4, -0.95, -0.3);
  scene.fill(-1.05, 0.3, -0.95, 0.4);
  test::inflate(scene, 0.2, 0.8, 3.0);
  return scene;
}

struct Memory {
  const char* of;
  Scene scene;
  bool afresh;  // loaded by a planner that has seen nothing else
  int cycles;
  bool drives, fails;  // along a way; at last
};

// Saved and loaded at each cycle, while it searches, follows and waits: the next decision is the same to the bit.
void expect_remembered_whole(const Memory& memory) {
  PlannerBench bench(memory.scene), copy(memory.scene);
  bool drove = false, failed = false;
  for (int k = 0; k < memory.cycles; ++k) {
    if (memory.afresh) copy = PlannerBench(memory.scene);
    Bytes state, again;
    bench.planner().save(state);
    ASSERT_TRUE(copy.planner().load(state));
    copy.planner().save(again);
    ASSERT_EQ(state, again) << k;
    copy.scene() = bench.scene();
    const Decision other = copy.cycle();
    const Decision& decision = bench.drive();
    ASSERT_EQ(decision.command, other.command) << k;
    ASSERT_EQ(decision.outcome, other.outcome) << k;
    ASSERT_EQ(decision.problem, other.problem) << k;
    ASSERT_EQ(bench.planner().totals(), copy.planner().totals()) << k;
    drove = drove || bench.planner().choice().rule == ChoiceReport::Rule::way;
    failed = failed || decision.outcome == Outcome::fail;
  }
  EXPECT_EQ(drove, memory.drives);
  EXPECT_EQ(failed, memory.fails);
}

TEST(Recovery, IsRememberedWhole) {
  const Memory memories[] = {
      {"a way past a thing", beside_a_thing(), false, 160, true, false},
      {"that there is none", walled_in_beside_a_thing(), false, 160, false, true},
      {"a search and its patience", patient_in_a_pocket(), true, 160, true, true},
      {"waiting", in_a_corridor(-0.5), false, 160, false, false},
      {"stepping back", along_a_corridor(0.5), true, 400, true, false},
      {"the way to the goal's heading", at_its_last_turn(), true, 160, true, false},
  };
  for (const Memory& memory : memories) {
    SCOPED_TRACE(memory.of);
    expect_remembered_whole(memory);
  }
}

}  // namespace
}  // namespace hidwa_local_planner
