// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "attack/drive.hpp"
#include "attack/walkers.hpp"
#include "study/attack_table.hpp"
#include "study_folder.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

using hidwa_attack::Case;

class AttackStudy : public StudyFolder {};

TEST(MixedAttack, EveryPromisedConditionHasItsTurnAndOneInTwentyIsOutside) {
  std::set<std::string> within, outside;
  int out = 0;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const hidwa_attack::Condition& condition = *hidwa_attack::mixed_case(1, k, {}).condition;
    (condition.promised ? within : outside).insert(condition.name);
    out += !condition.promised;
  }
  EXPECT_EQ(out, 100);  // 2000 / 20
  EXPECT_GE(within.size(), 30U);
  EXPECT_GE(outside.size(), 10U);
  for (const std::string& name : outside) EXPECT_EQ(name.rfind("out_", 0), 0U) << name;
  for (const std::string& name : within) EXPECT_NE(name.rfind("out_", 0), 0U) << name;
}

TEST(MixedAttack, ADriveDependsOnSeedAndNumberAlone) {
  for (std::uint64_t k = 0; k < 50; ++k) {
    const Case a = hidwa_attack::mixed_case(3, k, {}), b = hidwa_attack::mixed_case(3, k, {});
    EXPECT_EQ(a.seed, b.seed);
    EXPECT_EQ(a.spec.walkers, b.spec.walkers);
    EXPECT_NE(a.seed, hidwa_attack::mixed_case(4, k, {}).seed);
  }
}

// Drives that were made before: their seeds and draws stay.
TEST(MixedAttack, ADriveIsWhatItWas) {
  const Case first = hidwa_attack::mixed_case(1, 0, {}), outside = hidwa_attack::mixed_case(1, 19, {});
  EXPECT_EQ(first.condition->name, std::string("octagon"));
  EXPECT_EQ(first.seed, 1253891401689U);
  EXPECT_EQ(outside.condition->name, std::string("out_latency_more"));
  EXPECT_EQ(outside.seed, 2520970968058U);
}

TEST_F(AttackStudy, PartsAreTheWholeAndADriveAloneIsTheSame) {
  const std::string study = "attack --condition late,late_10hz --drives 3 --seconds 5 --seed 7 --threads 2 --out ";
  const Ended whole = run(study + "@whole");
  EXPECT_EQ(whole.code, 0) << whole.errors;
  EXPECT_NE(whole.out.find("\nwithin: drives 6, "), std::string::npos) << whole.out;
  EXPECT_EQ(run(study + "@one --shard 1/2").code, 0);
  EXPECT_EQ(run(study + "@two --shard 2/2").code, 0);
  EXPECT_EQ(run("merge --out @joined @one @two").code, 0);
  EXPECT_EQ(read("joined/runs.csv"), read("whole/runs.csv"));
  EXPECT_EQ(read("joined/summary.json"), read("whole/summary.json"));
  for (const std::string& contacts : column("whole", "touched")) EXPECT_EQ(contacts, "0");

  EXPECT_EQ(run("attack --condition late --seconds 5 --seed 7 --drive 2 --shard 2/8 --out @alone").code, 0);
  EXPECT_EQ(at("alone", "attack-P0002-late-S00001", "seed"), "9");
  EXPECT_EQ(lines_of("alone").at(1), lines_of("whole").at(5)) << "after two drives of each";
  const std::string trace = read("alone/trace.csv");
  EXPECT_GE(std::count(trace.begin(), trace.end(), '\n'), 500);  // 5 s, every 10 ms
}

TEST_F(AttackStudy, WhatMakesNoSenseIsRefused) {
  expect_refused("attack --condition anything,lazy --out @a", "no 'lazy': it needs some of octagon,");
  expect_refused("attack --condition late,mixed --out @a", "mixed stands alone");
  expect_refused("attack --condition late --map office.yaml --out @a", "with --condition mixed alone");
  expect_refused("attack --drive 3 --out @a", "--drive needs one --condition");
  EXPECT_EQ(run("attack --condition mixed --drives 1 --map nowhere.yaml --out @a").code, 2);
}

TEST_F(AttackStudy, TellsItsConditions) {
  const Ended told = run("attack --list");
  EXPECT_EQ(told.code, 0);
  for (const std::string& name : attack_conditions()) EXPECT_NE(told.out.find(name), std::string::npos) << name;
}

TEST(Attack, OnlyWhatIsFoundWithinThePromiseFailsIt) {
  hidwa_attack::DriveResult touched;
  touched.touched = true;
  const Plan plan = make_world_plan("attack", {17}, {"late"}, {{}});
  const study::Run& run = plan.runs.front();
  for (const auto& [name, held] : {std::pair("late", false), std::pair("out_slip", true)}) {
    const Case drive = hidwa_attack::case_of(*hidwa_attack::find_condition(name), 1);
    const Verdict verdict = attack_tables().verdict(plan, {attack_row(run, drive, touched)});
    EXPECT_EQ(verdict.held, held) << name;
    EXPECT_EQ(verdict.told.find("the same with --condition late --drive 17 and") == std::string::npos, held);
    EXPECT_TRUE(attack_tables().verdict(plan, {attack_row(run, drive, {})}).held) << name;
  }
}

// The check of touches can fail: people who are not told of touch the robot, or make it no encounter at all.
TEST(MixedAttack, SeesThatPeopleOfWhomThePlannerKnowsNothingTouchTheRobot) {
  std::uint64_t touched = 0, met = 0;
  for (std::uint64_t k = 0; k < 6; ++k) {
    Case drive = hidwa_attack::mixed_case(1, k, {});
    drive.spec.walkers = 6;
    drive.spec.walkers_told = false;
    const hidwa_attack::DriveResult result = hidwa_attack::drive(drive.spec, drive.seed);
    touched += result.encounters.moving;
    met += result.encounters.met;
  }
  EXPECT_GT(met, 0U);
  EXPECT_GT(touched, 0U);
}

TEST(Walkers, KeepTheirBounds) {
  const hidwa_attack::Bounds bounds;
  const hidwa_attack::Shape circle{{}, 0.25};
  hidwa_attack::Walkers walkers(5, bounds, circle, {}, 11);
  std::vector<hidwa_attack::Walker> before = walkers.all();
  for (int k = 0; k < 4000; ++k) {
    walkers.step({0.0, 0.0, 0.0}, {0.5, 0.0});
    for (std::size_t i = 0; i < before.size(); ++i) {
      const hidwa_attack::Walker& now = walkers.all()[i];
      if (now.id == before[i].id) {  // else somebody else has come
        const double change = std::hypot(now.v.x - before[i].v.x, now.v.y - before[i].v.y);
        EXPECT_LE(change, bounds.acc * hidwa_attack::Walkers::kStep + 1e-12);
        EXPECT_LE(std::hypot(now.v.x, now.v.y), bounds.speed + 1e-9);
      }
    }
    before = walkers.all();
  }
}

TEST(Walkers, NobodyAppearsNearerThanHeMay) {
  hidwa_attack::Bounds bounds;
  bounds.appear = 5.0;
  const hidwa_attack::Shape circle{{}, 0.25};
  hidwa_attack::Walkers walkers(6, bounds, circle, {}, 11);
  std::uint32_t newest = 0;
  int appeared = 0;
  for (int k = 0; k < 20000; ++k) {
    for (const hidwa_attack::Walker& walker : walkers.all()) {
      if (walker.id <= newest) continue;
      EXPECT_GE(walkers.gap(walker), k == 0 ? 5.0 : 5.0 - 0.005) << "it may have walked a step";
      newest = walker.id;
      ++appeared;
    }
    walkers.step({0.0, 0.0, 0.0}, {0.0, 0.0});
  }
  EXPECT_GT(appeared, 12) << "who touched is gone, and somebody else came";
}

// 2 m/s, 2.5 m/s2, 0.1 s of latency and two periods of 50 ms: 0.2 s and 0.8 s until it rests, in which it drives
// 0.4 m + 0.8 m, and a walker of 1.8 m/s walks 1.8 m. Turning adds more.
TEST(MixedAttack, WhoAppearsIsOutOfReachOfAFastRobot) {
  bool found = false;
  for (std::uint64_t index = 0; index < 400; ++index) {
    const hidwa_attack::Spec spec = hidwa_attack::mixed_case(1, index, {}).spec;
    const bool known = spec.parameters.max_vel_x == 2.0 && spec.parameters.decel_lim_x == 0.0 && spec.walkers > 0 &&
                       spec.period >= 50 && spec.parameters.control_latency >= 0.1;
    if (!known) continue;
    EXPECT_GE(spec.bounds.appear, 3.0);
    found = true;
  }
  EXPECT_TRUE(found);
}

TEST(Walkers, GapIsFromEdgeToEdge) {
  const hidwa_attack::Shape square{{{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}}, 0.0};
  hidwa_attack::Walkers walkers(1, {}, square, {1.0, 2.0, 0.5 * M_PI}, 3);
  hidwa_attack::Walker walker;
  walker.radius = 0.25;
  walker.p = {1.0, 3.0};  // 1 m ahead of the centre: 1 - 0.3 - 0.25
  EXPECT_NEAR(walkers.gap(walker), 0.45, 1e-12);
  walker.p = {0.0, 2.0};  // 1 m to the left: 1 - 0.2 - 0.25
  EXPECT_NEAR(walkers.gap(walker), 0.55, 1e-12);
  walker.p = {1.0, 2.1};  // inside, 0.2 from the front and from the sides: -0.2 - 0.25
  EXPECT_NEAR(walkers.gap(walker), -0.45, 1e-12);
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
