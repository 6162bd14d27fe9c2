// SPDX-License-Identifier: BSD-3-Clause
// DynaBARN-2D in two small worlds of the test's own, and a crowd in the office.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/key_frames.hpp"
#include "study/bystander.hpp"
#include "study/dynabarn_drive.hpp"
#include "study/encounter_table.hpp"
#include "study_folder.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// World 4: one cylinder far from the straight way. World 7: one that goes up and down the straight way, filling it.
const char* const kWorlds =
    "# two\n4 easy | a 0:0:8 100:0.5:8\n"
    "7 hard | a 0:9:0 5:-9:0 10:9:0 | b 0:9:1 5:-9:1 10:9:1 | c 0:9:-1 5:-9:-1 10:9:-1\n";
// One that comes towards the robot from in front, at 0.8 m/s, again and again.
const char* const kChase = "9 hard | a 0:6:0 10:14:0\n";

const std::string kQuick = " --set vx_samples=10 --set vth_samples=20 --set costmap.resolution=0.1";

class Encounters : public StudyFolder {
 protected:
  void SetUp() override {
    StudyFolder::SetUp();
    write("worlds.txt", kWorlds);
  }
  Ended study(const std::string& line) const { return run(line + kQuick); }
};

TEST_F(Encounters, AnEmptyWayIsDrivenAndAFullOneIsNot) {
  const Ended ended = study("dynabarn --worlds @worlds.txt --out @out --seeds 2 --mode AUTONOMY --tracking none");
  ASSERT_EQ(ended.code, 0) << ended.errors;
  ASSERT_EQ(lines_of("out").size(), 5U);
  for (const char* id : {"dynabarn-P0400-AUTONOMY-S00001", "dynabarn-P0401-AUTONOMY-S00001"}) {
    EXPECT_EQ(at("out", id, "success"), "1");
    // 19 m at no more than 2 m/s.
    EXPECT_GE(std::stod(at("out", id, "time")), 9.5);
    EXPECT_LT(std::stod(at("out", id, "time")), 14.0);
    EXPECT_EQ(at("out", id, "class"), "easy");
  }
  for (const char* id : {"dynabarn-P0700-AUTONOMY-S00001", "dynabarn-P0701-AUTONOMY-S00001"}) {
    EXPECT_EQ(at("out", id, "class"), "hard");
    if (at("out", id, "success") == "1") continue;
    EXPECT_EQ(std::stoi(at("out", id, "touched_moving")) + std::stoi(at("out", id, "touched_at_rest")) +
                  std::stoi(at("out", id, "touched_wall")) + std::stoi(at("out", id, "timeout")),
              1);
  }
  // The first one releases the robot at a time of its own.
  EXPECT_NE(at("out", "dynabarn-P0400-AUTONOMY-S00001", "release"),
            at("out", "dynabarn-P0401-AUTONOMY-S00001", "release"));
}

TEST_F(Encounters, ASlowRobotIsAsSlowBackwards) {
  write("chase.txt", kChase);
  const Ended ended = study("dynabarn --worlds @chase.txt --out @out --seeds 2 --mode AUTONOMY --speed 0.3");
  ASSERT_EQ(ended.code, 0) << ended.errors;
  for (const char* id : {"dynabarn-P0900-AUTONOMY-S00001", "dynabarn-P0901-AUTONOMY-S00001"}) {
    EXPECT_LE(std::stod(at("out", id, "length")), 0.3 * std::stod(at("out", id, "time")) + 0.01);
  }
}

TEST_F(Encounters, ShardsAndResumedStudiesAreTheSame) {
  const std::string all = "dynabarn --worlds @worlds.txt --seeds 1" + kQuick;
  ASSERT_EQ(run(all + " --out @whole").code, 0);
  EXPECT_EQ(lines_of("whole").size(), 7U);  // two worlds in three modes, and the head
  expect_sum_of_its_parts(all, "whole");
  const Ended resumed = run(all + " --out @part1");
  ASSERT_EQ(resumed.code, 0) << resumed.errors;
  EXPECT_NE(resumed.errors.find("3 runs are finished already"), std::string::npos) << resumed.errors;
  expect_same("whole", "part1");
  EXPECT_EQ(run(all + " --out @part1 --motion spline").code, 2);  // another study
}

TEST_F(Encounters, ACrowdIsMetAndItsMeasuresAreKept) {
  const Ended ended =
      run("crowd --out @out --people 6 --seeds 1 --mode AUTONOMY,HOSTILE --goal 12,12,0 --tracking none");
  ASSERT_EQ(ended.code, 0) << ended.errors;
  const std::string id = "crowd-P0001-AUTONOMY-S00001";
  EXPECT_EQ(at("out", id, "class"), "6 people");
  EXPECT_EQ(at("out", id, "world"), "office");
  EXPECT_LT(std::stod(at("out", id, "closest")), 20.0);
  EXPECT_GT(std::stod(at("out", "crowd-P0001-HOSTILE-S00001", "operator_active")), 0.0);
  const Ended nobody = run("crowd --out @none --people 0 --seeds 1 --mode AUTONOMY --goal 12,12,0");
  ASSERT_EQ(nobody.code, 0) << nobody.errors;
  EXPECT_EQ(at("none", id, "closest"), "99.000000");
  EXPECT_EQ(at("none", id, "success"), "1");
}

TEST_F(Encounters, WhatMakesNoSenseIsRefused) {
  write("broken.txt", "4 easy | a 0:0:8\n");
  const std::string line = "dynabarn --out @o --worlds @worlds.txt ";
  expect_refused("dynabarn --out @o", "--worlds is missing: a file of DynaBARN worlds");
  expect_refused("dynabarn --out @o --worlds @broken.txt", "line 1: the obstacle 'a'");
  expect_refused(line + "--mode AFTERMATH", "--mode AFTERMATH is for barn");
  expect_refused(line + "--tracking maybe", "--tracking is none");
  expect_refused(line + "--motion jumps", "--motion is linear or spline");
  expect_refused(line + "--speed 3", "--speed needs a number from 0.1 to 2");
  expect_refused(line + "--seeds 101", "--seeds is at most 100");
  expect_refused(line + "--people 3", "--people is for crowd");
  expect_refused("barn --out @o --worlds @worlds.txt --seeds 3", "--seeds is for dynabarn, crowd and passage");
  expect_refused("crowd --out @o --motion spline", "--motion is for dynabarn");
  expect_refused("crowd --out @o --yielding 2", "--yielding needs a number from 0 to 1");
  expect_refused("crowd --out @o --people 150 --seeds 1 --map @worlds.txt", "worlds.txt");
}

TEST(EncounterRow, TellsTouchesApart) {
  const Plan plan = make_world_plan("dynabarn", {401}, {"AUTONOMY"}, combinations({}));
  drive::DriveResult result;
  result.arrived = true;
  const auto said = [&](const std::string& column) {
    return cell(encounter_row(plan, plan.runs[0], {"4", "easy", 1, 2.0}, result), column, encounter_tables().columns);
  };
  EXPECT_EQ(said("success"), "1");
  EXPECT_EQ(said("touches"), "none");
  sim::Touch touch;
  touch.time = 3.5;
  touch.id = 7;
  touch.since_leap = 0.5;
  result.people.touches = {touch};
  result.people.contacts_at_rest = 1;
  EXPECT_EQ(said("success"), "0");
  EXPECT_EQ(said("touched_at_rest"), "1");
  EXPECT_EQ(said("touched_moving"), "0");
  EXPECT_EQ(said("touched_after_leap"), "1");
  EXPECT_EQ(said("touches"), "3.50:7:0:0:0.000:0.000:0.50");
  result.people.touches[0].since_leap = 0.51;
  EXPECT_EQ(said("touched_after_leap"), "0");
}

TEST(Release, IsSpreadOver20Seconds) {
  double low = 20.0, high = 0.0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    low = std::min(low, release_time(seed));
    high = std::max(high, release_time(seed));
  }
  EXPECT_GE(low, 0.0);
  EXPECT_LT(low, 1.0);
  EXPECT_GT(high, 19.0);
  EXPECT_LT(high, 20.0);
}

TEST(RoomAmong, LooksAheadAlongThePeoplesWays) {
  const auto people = std::make_shared<sim::KeyFramePeople>(
      std::vector<sim::KeyFrameTrack>{{{{0.0, {0.0, 0.0}}, {10.0, {10.0, 0.0}}}, sim::KeyMotion::linear}}, 0.5, 0.0);
  const Room room = room_among(people, {});
  EXPECT_NEAR(room({0.0, 2.0}, 0.0, 9.0), 1.5, 1e-12);
  EXPECT_NEAR(room({3.0, 2.0}, 3.0, 9.0), 1.5, 1e-12);  // 1 m/s for 3 s
  EXPECT_EQ(room({0.0, 9.0}, 0.0, 1.0), 1.0);           // at most
  const Room walled = room_among(people, [](const Eigen::Vector2d&, double, double) { return 0.25; });
  EXPECT_EQ(walled({0.0, 2.0}, 0.0, 9.0), 0.25);
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
