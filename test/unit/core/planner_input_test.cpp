// SPDX-License-Identifier: BSD-3-Clause
// Input that makes no sense gets a braked robot and a reason, never a crash or a wild command.
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/planner_bench.hpp"

namespace hidwa_local_planner {
namespace {

using test::PlannerBench;
using test::Scene;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Scene driving(double v = 0.3) {
  Scene scene = Scene::empty(61);
  scene.situation.velocity = scene.situation.last_command = {v, 0.0};
  return scene;
}

// The command must be the brake command, the reason must hold `word`.
void expect_braked(const Scene& scene, const std::string& word) {
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  EXPECT_EQ(decision.outcome, Outcome::brake) << word;
  EXPECT_NEAR(decision.command.v, 0.3 - 0.125, 1e-12) << word;  // 2.5 * 0.05
  EXPECT_EQ(decision.command.omega, 0.0) << word;
  EXPECT_NE(decision.problem.find(word), std::string::npos) << decision.problem;
  EXPECT_TRUE(bench.planner().candidates().empty());
}

struct Fault {
  const char* word;  // of the reason
  std::vector<double> values;
  void (*put)(Scene& scene, double value);
};

const std::vector<Fault> kFaults{
    {"not a number", {kNan, kInf, -kInf}, [](Scene& scene, double bad) { scene.situation.pose.x = bad; }},
    {"not a number", {kNan, kInf, -kInf}, [](Scene& scene, double bad) { scene.situation.pose.theta = bad; }},
    {"not a number", {kNan, kInf, -kInf}, [](Scene& scene, double bad) { scene.situation.velocity.v = bad; }},
    {"not a number", {kNan, kInf, -kInf}, [](Scene& scene, double bad) { scene.situation.velocity.omega = bad; }},
    {"impossibly large", {1e12}, [](Scene& scene, double bad) { scene.situation.pose.x = bad; }},
    {"impossibly large", {1e9}, [](Scene& scene, double bad) { scene.situation.velocity.v = bad; }},
    {"impossibly large", {-1e9}, [](Scene& scene, double bad) { scene.situation.velocity.omega = bad; }},
    {"the plan is empty", {0.0}, [](Scene& scene, double /*none*/) { scene.situation.plan.clear(); }},
    {"plan", {kNan}, [](Scene& scene, double bad) { scene.situation.plan[7].y = bad; }},
    {"plan", {kNan}, [](Scene& scene, double bad) { scene.situation.goal.theta = bad; }},
    {"period",
     {0.0, -0.05, 1e-9, 9e-4, kNan, kInf, 10.5, 1e300},
     [](Scene& scene, double bad) { scene.situation.period = bad; }},
    // Not even where the pose was led on from: that would take for ever.
    {"too old", {kNan, kInf, -0.01, 10.5, 1e12}, [](Scene& scene, double bad) { scene.situation.pose_age = bad; }},
    {"time", {kNan, kInf, -kInf, 1e13}, [](Scene& scene, double bad) { scene.situation.time = bad; }},
    {"time",
     {kNan, kInf, -kInf, 1e13},
     [](Scene& scene, double bad) {
       scene.situation.time = bad;
       scene.situation.pose_age = 0.1;  // led on by what was commanded when
     }},
    // A cell of 1 um could not be counted, nor one that is a continent away.
    {"resolution", {1e-6, 2e3, kInf}, [](Scene& scene, double bad) { scene.resolution = bad; }},
    {"origin", {kNan, kInf, 1e7}, [](Scene& scene, double bad) { scene.origin_x = bad; }},
    {"origin",
     {kNan, -kInf, -1e7},
     [](Scene& scene, double bad) {
       scene.origin_y = bad;
       // What moves is looked for on the map, too.
       scene.situation.moving_obstacles.emplace_back();
       scene.situation.moving_obstacles.back().points = {{0.0, 0.0}, {kNan, 1e300}};
     }},
    {"moving obstacle",
     {kNan, kInf},
     [](Scene& scene, double bad) { scene.situation.moving_obstacles = {test::mover_at(bad, 0.0)}; }},
    // The outline's size counts for a pose that has to be led on, and is none here.
    {"not a number",
     {kInf},
     [](Scene& scene, double bad) {
       scene.situation.pose_age = 0.1;
       scene.outline = {{bad, 0.1}, {-0.1, 0.1}, {0.0, -0.1}};
     }},
};

TEST(BadInput, IsNamedAndTheRobotBrakes) {
  for (const Fault& fault : kFaults) {
    for (const double value : fault.values) {
      Scene scene = driving();
      fault.put(scene, value);
      SCOPED_TRACE(value);
      expect_braked(scene, fault.word);
    }
  }
}

// Such a command was never sent. No command starts from a reading that no command explains: zero it is, and a failure.
TEST(BadInput, TheLastCommand) {
  for (const double bad : {kNan, kInf, -kInf}) {
    for (const Method method : {Method::paper, Method::hidwa}) {
      Scene scene = driving();
      scene.situation.last_command.omega = bad;
      scene.parameters.method = method;
      PlannerBench bench(scene);
      const Decision& decision = bench.cycle();
      EXPECT_EQ(decision.outcome, Outcome::fail);
      EXPECT_TRUE(decision.command == Twist2{});
      EXPECT_NE(decision.problem.find("not a number"), std::string::npos) << decision.problem;
    }
  }
}

// A second passed since the cycle before, and braking may make up for as much as the longest period: 2.5 * 0.1 m/s.
// Where that is no period, for none: 2.5 * 0.05 m/s.
TEST(BadInput, TheLongestPeriod) {
  const auto braked_by = [](double longest) {
    Scene scene = driving();
    scene.situation.longest_period = longest;
    scene.situation.plan.clear();
    PlannerBench bench(scene);
    bench.cycle();
    bench.scene().situation.time += 1.0;
    return 0.3 - bench.cycle().command.v;
  };
  EXPECT_NEAR(braked_by(0.1), 0.25, 1e-12);
  for (const double longest : {kNan, kInf, -1.0, 1e300}) EXPECT_NEAR(braked_by(longest), 0.125, 1e-12) << longest;
}

// Two poses 2000 km apart: what lies between is looked at, but not for seconds.
TEST(OddInput, APlanThatLeapsFar) {
  Scene scene = driving();
  for (int k = 0; k < 40; ++k) scene.situation.plan.push_back({k % 2 == 0 ? 9e5 : -9e5, 0.0, 0.0});
  PlannerBench bench(scene);
  EXPECT_EQ(bench.cycle().outcome, Outcome::drive);
}

TEST(BadInput, TheOperatorCommand) {
  for (const Influence influence : {Influence::shared, Influence::direct}) {
    for (const bool guarded : {true, false}) {
      Scene scene = driving();
      scene.steer({kNan, 0.0});
      scene.intent.influence = influence;
      scene.intent.guarded = guarded;
      expect_braked(scene, "operator command");
      scene.intent.u_h = {0.5, kInf};
      expect_braked(scene, "operator command");
    }
  }
}

TEST(BadInput, MapAndFootprint) {
  Scene scene = driving();
  PlannerBench bench(scene);
  const Decision no_map = bench.planner().plan(scene.situation, GridView(), scene.intent);
  EXPECT_EQ(no_map.outcome, Outcome::brake);
  EXPECT_NE(no_map.problem.find("costmap"), std::string::npos);
  bench.planner().set_footprint({});
  const Decision no_body = bench.cycle();
  EXPECT_EQ(no_body.outcome, Outcome::brake);
  EXPECT_NE(no_body.problem.find("robot_radius"), std::string::npos);
}

TEST(BadInput, AFootprintThatIsNoRobots) {
  PlannerBench bench(driving());
  const auto fault = [&bench](const Polygon& outline) {
    bench.planner().set_footprint(outline);
    const Decision& decision = bench.cycle();
    EXPECT_EQ(decision.outcome, Outcome::brake);
    EXPECT_EQ(decision.problem_kind, Problem::input);
    EXPECT_EQ(decision.candidates, 0u);  // nothing was made for it
    return decision.problem;
  };
  EXPECT_NE(fault({{100.0, 100.0}, {-100.0, 100.0}, {-100.0, -100.0}, {100.0, -100.0}}).find("20 m"),
            std::string::npos);
  EXPECT_NE(fault({{kNan, 0.1}, {-0.1, 0.1}, {0.0, -0.1}}).find("not a number"), std::string::npos);
  EXPECT_NE(fault({{0.2, 0.0}, {-0.2, 0.0}}).find("footprint_padding"), std::string::npos);
  // 61 cells of 0.05 m: the diagonal is 3.05 sqrt(2) = 4.31 m, and no place on the map has this corner on it too.
  EXPECT_NE(fault({{4.4, 0.0}, {-0.1, 0.1}, {-0.1, -0.1}}).find("larger than the local map"), std::string::npos);
  bench.planner().set_footprint(bench.scene().outline);
  EXPECT_EQ(bench.cycle().outcome, Outcome::drive);
}

TEST(BadInput, AtRestItIsAFailure) {
  Scene scene = driving(0.0);
  scene.situation.plan.clear();
  PlannerBench bench(scene);
  EXPECT_EQ(bench.cycle().outcome, Outcome::fail);
  EXPECT_TRUE(bench.cycle().command == Twist2{});
}

TEST(BadInput, TheNextCycleIsAsGoodAsNew) {
  Scene scene = driving();
  PlannerBench bench(scene);
  const Decision before = bench.cycle();
  bench.scene().situation.pose.x = kNan;
  bench.cycle();
  bench.scene().situation.pose.x = 0.0;
  const Decision& after = bench.cycle();
  EXPECT_TRUE(after.command == before.command);
  EXPECT_EQ(after.total, before.total);
}

TEST(OddInput, AReferenceOutsideTheLimitsIsBroughtBack) {
  Scene scene = driving();
  scene.situation.velocity = scene.situation.last_command = {0.9, -1.6};
  for (const Generator generator : {Generator::standard, Generator::dwa}) {
    scene.parameters.generator = generator;
    PlannerBench bench(scene);
    const Decision& decision = bench.cycle();
    EXPECT_NEAR(decision.command.v, 0.775, 1e-12);      // 0.9 - 0.125
    EXPECT_NEAR(decision.command.omega, -1.44, 1e-12);  // -1.6 + 0.16
  }
}

TEST(OddInput, ARobotOffItsMap) {
  Scene scene = driving();
  scene.situation.pose.x = 30.0;
  PlannerBench bench(scene);
  const Decision& decision = bench.cycle();
  EXPECT_NE(decision.outcome, Outcome::drive);
  EXPECT_NEAR(decision.command.v, 0.175, 1e-12);
}

}  // namespace
}  // namespace hidwa_local_planner
