// SPDX-License-Identifier: BSD-3-Clause
#include "core/motion/odometry_belief.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/util/archive.hpp"

namespace hidwa_local_planner {
namespace {

constexpr double kPeriod = 0.05;              // [s]
constexpr double kTolerance = 0.2;            // [m/s]
const AxisLimits kAxis{-0.2, 0.5, 2.5, 2.5};  // [m/s, m/s^2]

// One axis whose commands explain `explained`, read at 20 Hz. From one reading to the next a velocity follows if it
// changes by no more than 0.2 + 2.5 * 0.05 = 0.325 m/s.
class Axis {
 public:
  explicit Axis(const Interval& explained = {0.0, 0.0}) : explained_(explained) {}
  OdometryReading read(double measured) {
    time_ += kPeriod;
    return belief_.judge(time_, time_, measured, explained_, kTolerance, kAxis);
  }
  void pause(double seconds) { time_ += seconds; }
  // So often, and what the last one was taken for.
  OdometryReading read(double measured, int times) {
    OdometryReading reading = OdometryReading::agrees;
    for (int k = 0; k < times; ++k) reading = read(measured);
    return reading;
  }
  AxisBelief& belief() { return belief_; }
  double time() const { return time_; }

 private:
  Interval explained_;
  AxisBelief belief_;
  double time_ = 100.0;  // [s]
};

struct Story {
  const char* what;
  Interval explained;
  struct Step {
    double measured;
    OdometryReading reading;
  };
  std::vector<Step> steps;
};

TEST(OdometryBelief, JudgesEachReadingByTheCommandsAndThoseBefore) {
  constexpr OdometryReading agrees = OdometryReading::agrees, maybe_slower = OdometryReading::maybe_slower,
                            slower = OdometryReading::slower, doubted = OdometryReading::doubted;
  const Story stories[] = {
      {"it agrees within the tolerance", {0.1, 0.4}, {{-0.09, agrees}, {0.25, agrees}, {0.59, agrees}}},
      {"it is slower once three in a row agree",
       {0.3, 0.5},
       {{0.09, maybe_slower}, {0.0, maybe_slower}, {-0.19, slower}, {0.0, slower}}},
      {"backwards too", {-0.5, -0.3}, {{-0.09, maybe_slower}, {-0.09, maybe_slower}, {0.19, slower}}},
      {"it is faster: 0.5 + 0.21", {0.3, 0.5}, {{0.71, doubted}}},
      {"it goes the other way: -0.21", {0.3, 0.5}, {{-0.21, doubted}}},
      {"it is faster backwards", {-0.5, -0.3}, {{-0.71, doubted}}},
      {"it goes the other way from there", {-0.5, -0.3}, {{0.21, doubted}}},
      {"it moves without a command", {0.0, 0.0}, {{5.0, doubted}}},
      {"an outlier changes nothing", {0.3, 0.5}, {{0.4, agrees}, {5.0, doubted}, {0.4, agrees}}},
  };
  for (const Story& story : stories) {
    Axis axis(story.explained);
    for (const Story::Step& step : story.steps) EXPECT_EQ(axis.read(step.measured), step.reading) << story.what;
    EXPECT_FALSE(axis.belief().sure()) << story.what;
  }
}

TEST(OdometryBelief, SlowerOnesThatAreNotInARowOrDoNotAgreeAreNeverBelieved) {
  Axis interrupted({0.3, 0.5});
  for (int k = 1; k < 40; ++k)
    EXPECT_NE(interrupted.read(k % 3 > 0 ? 0.0 : 0.4), OdometryReading::slower) << k;  // two, and one that agrees
  Axis between({0.3, 0.5});
  for (int k = 1; k < 40; ++k)
    EXPECT_NE(between.read(k % 3 > 0 ? 0.0 : 5.0), OdometryReading::slower) << k;  // two, and one that is too fast
  Axis jumping({0.6, 0.7});  // from 0.39 to 0.0 m/s: more than 0.325
  for (int k = 1; k < 40; ++k) EXPECT_EQ(jumping.read(k % 2 > 0 ? 0.39 : 0.0), OdometryReading::maybe_slower) << k;
}

TEST(OdometryBelief, OneReadingThatManyCyclesFindIsOne) {
  AxisBelief belief;
  const auto judge = [&belief](double now, double heard) {
    return belief.judge(now, heard, 0.0, {0.5, 0.5}, kTolerance, kAxis);
  };
  for (int k = 0; k < 10; ++k) EXPECT_EQ(judge(100.0 + kPeriod * k, 100.0), OdometryReading::maybe_slower) << k;
  EXPECT_EQ(judge(100.5, 100.5), OdometryReading::maybe_slower);
  EXPECT_EQ(judge(100.7, 100.7), OdometryReading::slower);
  EXPECT_EQ(judge(100.75, 100.7), OdometryReading::slower);
}

TEST(OdometryBelief, BetweenTwoCyclesWhatTheCommandsDoNotExplainIsDoubted) {
  const Interval explained{0.3, 0.5};
  const auto believed = [&explained](Axis& axis, double measured) {
    return axis.belief().believed(measured, explained, kTolerance, 0.4);
  };
  Axis axis(explained);
  axis.read(0.0, 2);
  EXPECT_EQ(believed(axis, 0.2), 0.2);  // explained: 0.3 - 0.2 is less
  EXPECT_EQ(believed(axis, 0.0), 0.4);
  EXPECT_EQ(believed(axis, 5.0), 0.4);
  axis.read(0.0);
  EXPECT_EQ(believed(axis, 0.01), 0.01);
}

TEST(OdometryBelief, ManyOutliersOneAtATimeChangeNothing) {
  Axis axis({0.3, 0.5});
  for (int k = 0; k < 40; ++k)
    EXPECT_EQ(axis.read(k % 2 > 0 ? 5.0 : 0.4), k % 2 > 0 ? OdometryReading::doubted : OdometryReading::agrees);
}

TEST(OdometryBelief, WhatAgreesWithItselfForThreeTenthsOfASecondIsBelieved) {
  Axis axis;
  for (int k = 0; k < 6; ++k) EXPECT_EQ(axis.read(0.8), OdometryReading::doubted) << k;  // 0 to 0.25 s
  axis.pause(0.001);                                                                     // rounding: 0.3 s and a bit
  EXPECT_EQ(axis.read(0.8), OdometryReading::faster);
  EXPECT_TRUE(axis.belief().sure());
  EXPECT_EQ(axis.belief().believed(), 0.8);
}

TEST(OdometryBelief, ItMayChangeAsFastAsARobotCan) {
  Axis rolling;  // 0.3 m/s a reading: less than 0.325
  for (int k = 1; k <= 7; ++k) rolling.read(0.3 * k);
  EXPECT_EQ(rolling.read(2.4), OdometryReading::faster);
  EXPECT_EQ(rolling.belief().believed(), 2.4);
  Axis jumping;  // 0.35 m/s a reading
  for (int k = 1; k <= 20; ++k) EXPECT_EQ(jumping.read(0.35 * k), OdometryReading::doubted);
}

TEST(OdometryBelief, FaultsThatDisagreeAreNeverBelieved) {
  Axis axis;
  for (int k = 0; k < 40; ++k) EXPECT_EQ(axis.read(k % 2 > 0 ? 5.0 : -3.0), OdometryReading::doubted);
}

TEST(OdometryBelief, AnOutlierAmongBelievedOnesLeavesWhatWasBelieved) {
  Axis axis;
  axis.read(0.8, 8);
  EXPECT_EQ(axis.read(9.0), OdometryReading::faster);
  EXPECT_EQ(axis.belief().believed(), 0.8);
  EXPECT_EQ(axis.read(0.85), OdometryReading::faster);  // goes on at once
  EXPECT_EQ(axis.belief().believed(), 0.85);
}

TEST(OdometryBelief, WhatWasBelievedHoldsForThreeTenthsOfASecond) {
  Axis axis;
  axis.read(0.8, 8);
  for (int k = 1; k <= 5; ++k)
    EXPECT_EQ(axis.read(k % 2 > 0 ? 9.0 : -9.0), OdometryReading::faster) << k;  // up to 0.25 s
  axis.pause(0.001);
  EXPECT_EQ(axis.read(9.0), OdometryReading::doubted);
  EXPECT_FALSE(axis.belief().sure());
}

TEST(OdometryBelief, OneThatAgreesWithTheCommandsEndsIt) {
  Axis axis;
  axis.read(0.8, 8);
  EXPECT_EQ(axis.read(0.1), OdometryReading::agrees);
  EXPECT_FALSE(axis.belief().sure());
  EXPECT_EQ(axis.read(0.8), OdometryReading::doubted);
}

TEST(OdometryBelief, TimeThatGoesBackBeginsAnew) {
  Axis axis;
  axis.read(0.8, 8);
  axis.pause(-50.0);
  EXPECT_EQ(axis.read(0.8), OdometryReading::doubted);
  EXPECT_EQ(axis.read(0.8, 6), OdometryReading::faster);
}

TEST(OdometryBelief, SavedAndLoadedItGoesOn) {
  Axis axis;
  axis.read(0.8, 5);
  Bytes bytes;
  ArchiveWriter write(bytes);
  write(axis.belief());
  AxisBelief loaded;
  ArchiveReader read(bytes);
  read(loaded);
  EXPECT_TRUE(read.complete());
  EXPECT_EQ(loaded.judge(axis.time() + 0.05, axis.time() + 0.05, 0.8, {}, kTolerance, kAxis), OdometryReading::doubted);
  EXPECT_EQ(loaded.judge(axis.time() + 0.11, axis.time() + 0.11, 0.8, {}, kTolerance, kAxis),
            OdometryReading::faster);  // since 4 * 0.05 + 0.11 s
}

TEST(ReadingTolerance, InsideTheDeadBandARobotStands) {
  Parameters p;
  p.min_in_place_vel_theta = 0.4;
  EXPECT_EQ(reading_tolerance(p, {0.5, 0.3}).v, 0.2);
  EXPECT_DOUBLE_EQ(reading_tolerance(p, {0.5, 0.3}).omega, 0.8);  // 0.5 + 0.3
  EXPECT_DOUBLE_EQ(reading_tolerance(p, {0.5, -0.3}).omega, 0.8);
  EXPECT_DOUBLE_EQ(reading_tolerance(p, {0.5, 0.5}).omega, 0.5);  // beyond the dead band
}

}  // namespace
}  // namespace hidwa_local_planner
