// SPDX-License-Identifier: BSD-3-Clause
#include "record/cycle_record.hpp"

#include <array>

#include <gtest/gtest.h>

#include "support/recorded_drive.hpp"

namespace hidwa_local_planner::record {
namespace {

using test::RecordedDrive;

TEST(CycleRecord, ReadAndWrittenAgainItIsTheSameBytes) {
  int keys = 0, braked = 0;
  for (const RecordedDrive::Cycle& cycle : RecordedDrive(1, OperatorMode::joystick).run(300)) {
    CycleRecord record;
    ASSERT_EQ(decode(cycle.record, record), "");
    Bytes again;
    encode(record, again);
    EXPECT_EQ(again, cycle.record);
    keys += record.setup ? 1 : 0;
    braked += record.costmap ? 0 : 1;
    EXPECT_EQ(record.costmap.has_value(), record.observation.fault.empty());
    EXPECT_TRUE(!record.setup || record.plan);
    EXPECT_TRUE(identical(record.decision, cycle.decision));
    EXPECT_TRUE(identical(record.intent, cycle.intent));
  }
  EXPECT_EQ(keys, 3);  // cycles 1, 101 and 201
  EXPECT_GT(braked, 0);
}

// Every field of a decision counts, to the last bit.
TEST(CycleRecord, OneBitMakesADecisionAnother) {
  const DecisionRecord decision;
  EXPECT_TRUE(identical(decision, DecisionRecord()));
  std::vector<DecisionRecord> others(9);
  others[0].outcome = Outcome::hold;
  others[1].command.v = -0.0;
  others[2].command.omega = 5e-324;
  others[3].sample.v = 1.0;
  others[4].reference.omega = 1.0;
  others[5].total = 1e-300;
  others[6].agreement = std::nextafter(1.0, 0.0);
  others[7].candidates = 1;
  others[8].digest = 1;
  for (std::size_t i = 0; i < others.size(); ++i) EXPECT_FALSE(identical(decision, others[i])) << i;
}

TEST(CycleRecord, TheDigestSeesAllThatTheDecisionSays) {
  Decision decision;
  decision.trajectory = {{1.0, 2.0, 3.0}};
  decision.terms = {{"PathDist", 1.0, 2.0}};
  decision.rejections = {{"Collision", 3}};
  const std::vector<double> totals{1.0, 2.0};
  const std::uint64_t digest = decision_record(decision, totals).digest;
  EXPECT_EQ(decision_record(decision, totals).digest, digest);
  std::vector<Decision> others(6, decision);
  others[0].trajectory[0].theta = std::nextafter(3.0, 4.0);
  others[1].terms[0].raw = 1.5;
  others[2].rejections[0].count = 4;
  others[3].problem_kind = Problem::stuck;
  others[4].operator_rejected_by = "x";
  others[5].escaping = true;
  for (std::size_t i = 0; i < others.size(); ++i) EXPECT_NE(decision_record(others[i], totals).digest, digest) << i;
  EXPECT_NE(decision_record(decision, {1.0, std::nextafter(2.0, 3.0)}).digest, digest);
}

/// A key record, of a drive.
CycleRecord some_record() {
  CycleRecord record;
  EXPECT_EQ(decode(RecordedDrive(1, OperatorMode::joystick).run(1)[0].record, record), "");
  return record;
}

Bytes bytes_of(const CycleRecord& record) {
  Bytes bytes;
  encode(record, bytes);
  return bytes;
}

// What moves, and what the sensors look at; then, into the same record, none of either.
TEST(CycleRecord, MoversAndSectorsComeBackToTheBit) {
  CycleRecord some = some_record(), none = some, read;
  MovingObstacleEstimate mover;
  mover.id = 42;
  mover.position = {1.0 / 3.0, -2.0};
  mover.velocity = {0.1, 0.7};
  mover.radius = 0.3;
  mover.position_deviation = 0.01;
  mover.velocity_deviation = 0.02;
  mover.age = 0.05;
  mover.points = {{0.5, 0.25}, {0.1, 0.2}};
  some.observation.moving_obstacles = {mover};
  some.observation.sensor_sectors = {{{0.1, -1.0 / 3.0, 0.7}, 4.7, 12.0}, {{-0.2, 0.0, 3.1}, 1.5, 4.0}};
  for (const CycleRecord& written : {some, none}) {
    ASSERT_EQ(decode(bytes_of(written), read), "");
    EXPECT_EQ(read.observation.moving_obstacles.size(), written.observation.moving_obstacles.size());
    EXPECT_TRUE(read.observation.sensor_sectors == written.observation.sensor_sectors);
    EXPECT_EQ(bytes_of(read), bytes_of(written));
  }
}

TEST(CycleRecord, OfAnotherFormatIsToldByName) {
  CycleRecord record;
  const std::string others = ", this release reads format 7: replay it with the release that recorded it";
  EXPECT_EQ(decode({1, 0}, record), "the record's format is 1" + others);
  EXPECT_EQ(decode({6, 0, 5}, record), "the record's format is 6" + others);
  EXPECT_EQ(decode({99, 0}, record), "the record's format is 99" + others);
  EXPECT_EQ(decode({}, record), "the record is empty");
  EXPECT_EQ(decode({7}, record), "the record is empty");
}

TEST(CycleRecord, CutAnywhereOrLongerItIsTold) {
  Bytes bytes = bytes_of(some_record());
  CycleRecord record;
  for (std::size_t n = 2; n < bytes.size(); ++n) {
    const Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n));
    EXPECT_EQ(decode(cut, record), "the record is cut short or damaged") << n;
  }
  bytes.push_back(0);
  EXPECT_EQ(decode(bytes, record), "the record is cut short or damaged");
}

TEST(CycleRecord, AKeyRecordHasAPlan) {
  CycleRecord record = some_record();
  record.plan.reset();
  CycleRecord read;
  EXPECT_EQ(decode(bytes_of(record), read), "the record is damaged: it has parameters, but no plan");
  record.setup.reset();  // as one that follows others it is whole
  EXPECT_EQ(decode(bytes_of(record), read), "");
}

// What the control loop relies on is there, whoever wrote the record.
TEST(CycleRecord, WithoutAFaultThereAreACostmapAndAVelocity) {
  CycleRecord record = some_record();
  ASSERT_EQ(record.observation.fault, "");
  record.observation.velocity.reset();
  CycleRecord read;
  EXPECT_EQ(decode(bytes_of(record), read), "the record is damaged: it has no velocity, and no fault that explains it");
  for (const auto& [vx, vth, search] :
       {std::array{2000, 101, 0}, {1000000000, 0, 0}, {0, 200001, 0}, {5, 5, 1000001}}) {
    record.sampling.vx_samples = vx;
    record.sampling.vth_samples = vth;
    record.sampling.search_poses = search;
    EXPECT_EQ(decode(bytes_of(record), read), "the record is damaged: no planner tries so many samples") << vx;
  }
  record.sampling = {};
  record.costmap.reset();
  EXPECT_EQ(decode(bytes_of(record), read), "the record is damaged: it has no costmap, and no fault that explains it");
  record.observation.fault = "no odometry";
  EXPECT_EQ(decode(bytes_of(record), read), "");
}

}  // namespace
}  // namespace hidwa_local_planner::record
