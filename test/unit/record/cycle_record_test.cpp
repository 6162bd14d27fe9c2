// SPDX-License-Identifier: BSD-3-Clause
#include "record/cycle_record.hpp"

#include <array>

#include <gtest/gtest.h>

#include "support/recorded_drive.hpp"

namespace hidwa_local_planner::record {
namespace {

using test::Random;
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

/// A part as the container has it.
struct Part {
  std::string name;
  bool critical = true;
  Bytes bytes;
};

std::vector<Part> parts_of(const Bytes& record) {
  std::vector<Part> parts;
  ArchiveReader read(record);
  std::uint16_t format = 0;
  read(format);
  while (!read.complete() && !read.failed()) {
    parts.emplace_back();
    read(parts.back().name, parts.back().critical, parts.back().bytes);
  }
  EXPECT_FALSE(read.failed());
  return parts;
}

Bytes joined(const std::vector<Part>& parts) {
  Bytes bytes;
  ArchiveWriter write(bytes);
  write(kFormat);
  for (const Part& part : parts) write(part.name, part.critical, part.bytes);
  return bytes;
}

TEST(CycleRecord, OfAnotherFormatIsToldByNameWithTheReleaseThatReadsIt) {
  CycleRecord record;
  Bytes key;
  ArchiveWriter write(key);
  write(std::uint16_t{3}, std::uint32_t{17}, true, std::string("0.1.0"), std::string("max_vel_x 0.5"));
  EXPECT_EQ(
      decode(key, record),
      "the record's format is 3, this release reads format 6: replay it with the release that recorded it, 0.1.0");
  const std::string anonymous = "this release reads format 6: replay it with the release that recorded it";
  Bytes other;
  ArchiveWriter write_other(other);
  write_other(std::uint16_t{2}, std::uint32_t{18}, false, 1.5);
  EXPECT_EQ(decode(other, record), "the record's format is 2, " + anonymous);
  EXPECT_EQ(decode({1, 0}, record), "the record's format is 1, " + anonymous);
  EXPECT_EQ(decode({4, 0}, record), "the record's format is 4, " + anonymous);
  EXPECT_EQ(decode({99, 0}, record), "the record's format is 99, " + anonymous);
  EXPECT_EQ(decode({}, record), "the record is empty");
  EXPECT_EQ(decode({6}, record), "the record is empty");
}

// Cut behind a part, those behind it are missing.
TEST(CycleRecord, CutAnywhereItIsTold) {
  const Bytes bytes = bytes_of(some_record());
  CycleRecord record;
  int cut_within = 0, cut_between = 0;
  for (std::size_t n = 2; n < bytes.size(); ++n) {
    const std::string fault = decode(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n)), record);
    const bool within = fault == "the record is cut short";
    cut_within += within ? 1 : 0;
    cut_between += within ? 0 : 1;
    EXPECT_TRUE(within || fault.rfind("the record has no part '", 0) == 0) << n << ": " << fault;
  }
  EXPECT_EQ(cut_between, 10);  // parts
  EXPECT_GT(cut_within, 100);
}

TEST(CycleRecord, TheOrderOfPartsDoesNotMatter) {
  const Bytes bytes = bytes_of(some_record());
  std::vector<Part> parts = parts_of(bytes);
  Random random(5);
  for (int k = 0; k < 20; ++k) {
    const auto last = static_cast<int>(parts.size()) - 1;
    const int one = random.integer(0, last), other = random.integer(0, last);
    std::swap(parts[static_cast<std::size_t>(one)], parts[static_cast<std::size_t>(other)]);
    CycleRecord record;
    ASSERT_EQ(decode(joined(parts), record), "");
    EXPECT_EQ(bytes_of(record), bytes);
  }
}

TEST(CycleRecord, AMissingPartIsNamed) {
  const std::vector<Part> all = parts_of(bytes_of(some_record()));
  ASSERT_EQ(all.size(), 10u);
  CycleRecord record;
  for (const Part& missing : all) {
    std::vector<Part> parts;
    for (const Part& part : all) {
      if (part.name != missing.name) parts.push_back(part);
    }
    // Without a setup it is no key record, and as one that follows others it is whole.
    EXPECT_EQ(decode(joined(parts), record),
              missing.name == "setup" ? "" : "the record has no part '" + missing.name + "'");
  }
}

// A part of another layout does not end where its bytes do.
TEST(CycleRecord, ADamagedPartIsNamed) {
  const std::vector<Part> all = parts_of(bytes_of(some_record()));
  CycleRecord record;
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (const bool longer : {false, true}) {
      std::vector<Part> parts = all;
      parts[k].bytes.resize(longer ? parts[k].bytes.size() + 1 : parts[k].bytes.size() - 1);
      EXPECT_EQ(decode(joined(parts), record), "the record is damaged: its part '" + parts[k].name + "'");
    }
  }
  std::vector<Part> twice = all;
  twice.push_back(all[3]);
  EXPECT_EQ(decode(joined(twice), record), "the record is damaged: it has the part '" + all[3].name + "' twice");
}

TEST(CycleRecord, AnUnknownPartIsPassedOverAndToldWhereItIsCritical) {
  const Bytes bytes = bytes_of(some_record());
  std::vector<Part> parts = parts_of(bytes);
  parts.insert(parts.begin() + 2, {"remarks", false, {1, 2, 3}});
  CycleRecord record;
  EXPECT_EQ(decode(joined(parts), record), "");
  EXPECT_TRUE(record.unknown.empty());
  EXPECT_EQ(bytes_of(record), bytes);
  parts.insert(parts.begin() + 5, {"obstacles", true, {}});
  EXPECT_EQ(decode(joined(parts), record), "");
  EXPECT_EQ(record.unknown, std::vector<std::string>{"obstacles"});
  EXPECT_EQ(bytes_of(record), bytes);
}

// The results alone are not critical: without them a cycle can be repeated, though not compared.
TEST(CycleRecord, WhatACycleIsDecidedFromIsCritical) {
  for (const Part& part : parts_of(bytes_of(some_record()))) {
    EXPECT_EQ(part.critical, part.name != "intent" && part.name != "verdict") << part.name;
  }
}

// What the control loop relies on is there, whoever wrote the record.
TEST(CycleRecord, WithoutAFaultThereIsAVelocity) {
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
  record.observation.fault = "no odometry";
  record.costmap.reset();
  EXPECT_EQ(decode(bytes_of(record), read), "");
}

}  // namespace
}  // namespace hidwa_local_planner::record
