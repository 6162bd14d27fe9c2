// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/record/cycle_record.hpp"

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
    braked += record.braked ? 1 : 0;
    EXPECT_NE(record.braked.has_value(), record.planned.has_value());
    EXPECT_TRUE(identical(record.verdict, cycle.verdict));
    EXPECT_TRUE(identical(record.intent, cycle.intent));
  }
  EXPECT_EQ(keys, 3);  // cycles 1, 101 and 201
  EXPECT_GT(braked, 0);
}

// Every field of a verdict counts, to the last bit.
TEST(CycleRecord, OneBitMakesAVerdictAnother) {
  const Verdict verdict;
  EXPECT_TRUE(identical(verdict, Verdict()));
  std::vector<Verdict> others(9);
  others[0].outcome = Outcome::hold;
  others[1].command.v = -0.0;
  others[2].command.omega = 5e-324;
  others[3].sample.v = 1.0;
  others[4].reference.omega = 1.0;
  others[5].total = 1e-300;
  others[6].agreement = std::nextafter(1.0, 0.0);
  others[7].candidates = 1;
  others[8].digest = 1;
  for (std::size_t i = 0; i < others.size(); ++i) EXPECT_FALSE(identical(verdict, others[i])) << i;
}

TEST(CycleRecord, TheDigestSeesAllThatTheDecisionSays) {
  Decision decision;
  decision.trajectory = {{1.0, 2.0, 3.0}};
  decision.terms = {{"PathDist", 1.0, 2.0}};
  decision.refusals = {{"Collision", 3}};
  const std::vector<double> totals{1.0, 2.0};
  const std::uint64_t digest = verdict_of(decision, totals).digest;
  EXPECT_EQ(verdict_of(decision, totals).digest, digest);
  std::vector<Decision> others(6, decision);
  others[0].trajectory[0].theta = std::nextafter(3.0, 4.0);
  others[1].terms[0].raw = 1.5;
  others[2].refusals[0].count = 4;
  others[3].problem = "x";
  others[4].operator_refused_by = "x";
  others[5].escaping = true;
  for (std::size_t i = 0; i < others.size(); ++i) EXPECT_NE(verdict_of(others[i], totals).digest, digest) << i;
  EXPECT_NE(verdict_of(decision, {1.0, std::nextafter(2.0, 3.0)}).digest, digest);
}

TEST(CycleRecord, OfAnotherFormatOrDamagedIsToldInWords) {
  Bytes bytes;
  encode(CycleRecord(), bytes);
  CycleRecord record;
  Bytes other = bytes;
  other[0] = 99;
  EXPECT_EQ(decode(other, record), "the record's format is 99, this program reads 3: use the release that recorded it");
  EXPECT_EQ(decode({}, record), "the record is empty");
  for (std::size_t n = 2; n < bytes.size(); ++n) {
    EXPECT_EQ(decode(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n)), record),
              "the record is damaged");
  }
}

}  // namespace
}  // namespace hidwa_local_planner::record
