// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "attack/drive.hpp"
#include "attack/hostile.hpp"
#include "attack/walkers.hpp"
#include "study_folder.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

using hidwa_attack::HostileDrive;

class HostileStudy : public StudyFolder {};

TEST(Hostile, EveryPromisedConditionHasItsTurnAndOneInTwentyIsOutside) {
  std::set<std::string> within, outside;
  int out = 0;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const HostileDrive drive = hidwa_attack::hostile_drive(1, k, {});
    (drive.promised ? within : outside).insert(drive.condition);
    out += !drive.promised;
  }
  EXPECT_EQ(out, 100);  // 2000 / 20
  EXPECT_GE(within.size(), 30U);
  EXPECT_GE(outside.size(), 10U);
  for (const std::string& name : outside) EXPECT_EQ(name.rfind("out_", 0), 0U) << name;
  for (const std::string& name : within) EXPECT_NE(name.rfind("out_", 0), 0U) << name;
}

TEST(Hostile, ADriveDependsOnSeedAndIndexAlone) {
  for (std::uint64_t k = 0; k < 50; ++k) {
    const HostileDrive a = hidwa_attack::hostile_drive(3, k, {}), b = hidwa_attack::hostile_drive(3, k, {});
    EXPECT_EQ(a.seed, b.seed);
    EXPECT_EQ(a.spec.walkers, b.spec.walkers);
    EXPECT_NE(a.seed, hidwa_attack::hostile_drive(4, k, {}).seed);
  }
}

TEST_F(HostileStudy, PartsOfAStudyAreTheStudy) {
  const std::string study = "hostile --cycles 2000 --seed 7 --threads 2 --out ";
  EXPECT_EQ(run(study + "@whole").code, 0);
  EXPECT_EQ(run(study + "@one --shard 1/2").code, 0);
  EXPECT_EQ(run(study + "@two --shard 2/2").code, 0);
  EXPECT_EQ(run("merge --out @joined @one @two").code, 0);
  EXPECT_EQ(read("joined/drives.csv"), read("whole/drives.csv"));
  EXPECT_EQ(read("joined/summary.json"), read("whole/summary.json"));

  // Called again it keeps what is there; a line that was cut short is made again.
  const std::string drives = read("whole/drives.csv");
  write("whole/drives.csv", drives.substr(0, drives.size() - 20));
  EXPECT_EQ(run(study + "@whole").code, 0);
  EXPECT_EQ(read("whole/drives.csv"), drives);

  const nlohmann::json summary = nlohmann::json::parse(read("whole/summary.json")).at("within");
  EXPECT_GE(summary.at("cycles").get<int>(), 2000);
  EXPECT_EQ(summary.at("contacts").get<int>(), 0);
  EXPECT_GT(summary.at("moving").get<double>(), 0.2);
}

TEST_F(HostileStudy, AnotherStudysFolderIsRefused) {
  EXPECT_EQ(run("hostile --cycles 1 --out @study").code, 0);
  expect_refused("hostile --cycles 1 --seed 2 --out @study", "holds another study");
  EXPECT_EQ(run("hostile --cycles 1 --map nowhere.yaml --out @other").code, 2);
}

TEST_F(HostileStudy, ASoakOfSixMinutesHolds) {
  const auto soak = run("soak --hours 0.1 --out @soak");
  EXPECT_NE(soak.errors.find("6 of 6 minutes, 0 s left"), std::string::npos) << soak.errors;
  const nlohmann::json summary = nlohmann::json::parse(read("soak/summary.json"));
#ifdef HIDWA_SANITIZED  // a sanitizer's own memory grows: all but that is judged
  for (const char* name : {"contacts", "commands_beyond_limits", "touched_moving"}) EXPECT_EQ(summary.at(name), 0);
#else
  EXPECT_EQ(soak.code, 0) << summary;
#endif
  // 360 s at 20 Hz are 7200 cycles; one in ten comes up to 0.1 s late.
  EXPECT_GT(summary.at("cycles").get<int>(), 6000);
  EXPECT_LE(summary.at("cycles").get<int>(), 7200);
  EXPECT_GE(summary.at("states").size(), 5U) << summary;
  const std::string minutes = read("soak/minutes.csv");
  EXPECT_EQ(std::count(minutes.begin(), minutes.end(), '\n'), 7);  // the head and six minutes
}

// The check of touches can fail: people who are not told of touch the robot, or make it no encounter at all.
TEST(Hostile, SeesThatPeopleOfWhomThePlannerKnowsNothingTouchTheRobot) {
  std::uint64_t touched = 0, met = 0;
  for (std::uint64_t k = 0; k < 6; ++k) {
    HostileDrive drive = hidwa_attack::hostile_drive(1, k, {});
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
TEST(Hostile, WhoAppearsIsOutOfReachOfAFastRobot) {
  bool found = false;
  for (std::uint64_t index = 0; index < 400; ++index) {
    const hidwa_attack::Spec spec = hidwa_attack::hostile_drive(1, index, {}).spec;
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
