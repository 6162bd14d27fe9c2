// SPDX-License-Identifier: BSD-3-Clause
#include "input/yielding.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner::input {
namespace {

using Phase = Yielding::Phase;

// 0.5 s of quiet, 10 s in all.
const Yielding::Settings kDefaults;

TEST(Yielding, GoesOnAtOnceWhereTheRobotStandsAndNobodyAttends) {
  Yielding yielding(kDefaults);
  EXPECT_EQ(yielding.step(100.0, true, false), Phase::quiet);
}

TEST(Yielding, BrakesFirst) {
  Yielding yielding(kDefaults);
  EXPECT_EQ(yielding.step(100.0, false, false), Phase::braking);
  EXPECT_EQ(yielding.step(100.2, false, false), Phase::braking);
  EXPECT_EQ(yielding.step(100.25, true, false), Phase::quiet);
}

TEST(Yielding, WaitsUntilNobodyHasAttendedForTheQuietTime) {
  Yielding yielding(kDefaults);
  EXPECT_EQ(yielding.step(100.0, true, true), Phase::yielding);
  EXPECT_EQ(yielding.step(105.0, true, true), Phase::yielding);
  EXPECT_EQ(yielding.step(105.49, true, false), Phase::yielding);
  EXPECT_EQ(yielding.step(105.51, true, false), Phase::quiet);
}

TEST(Yielding, ATouchBeginsTheQuietTimeAnew) {
  Yielding yielding(kDefaults);
  yielding.step(100.0, true, true);
  EXPECT_EQ(yielding.step(100.4, true, false), Phase::yielding);
  EXPECT_EQ(yielding.step(100.45, true, true), Phase::yielding);
  EXPECT_EQ(yielding.step(100.9, true, false), Phase::yielding);  // 0.45 s
  EXPECT_EQ(yielding.step(101.0, true, false), Phase::quiet);     // 0.55 s
}

TEST(Yielding, GivesWayForAsLongAsItsPatienceOnly) {
  Yielding yielding(kDefaults);
  yielding.step(100.0, true, true);
  EXPECT_EQ(yielding.step(109.9, true, true), Phase::yielding);
  EXPECT_EQ(yielding.step(110.1, true, true), Phase::out_of_patience);
}

// Odometry that never says "stands" (a drifting gyroscope) does not keep the host for ever.
TEST(Yielding, ARobotThatNeverStandsCostsThePatienceToo) {
  Yielding yielding(kDefaults);
  yielding.step(100.0, false, false);
  EXPECT_EQ(yielding.step(110.1, false, false), Phase::out_of_patience);
}

TEST(Yielding, TimeThatGoesBackIsNoTime) {
  Yielding yielding(kDefaults);
  yielding.step(100.0, true, true);
  EXPECT_EQ(yielding.step(50.0, true, false), Phase::yielding);
  EXPECT_EQ(yielding.step(50.4, true, false), Phase::yielding);
  EXPECT_EQ(yielding.step(50.6, true, false), Phase::quiet);
}

TEST(Yielding, WhoStopsOrSteersAttends) {
  using State = OperatorStateId;
  for (const State state : {State::shared, State::blocked, State::manual, State::stopped}) {
    EXPECT_TRUE(attends(state, false)) << to_string(state);
  }
  for (const State state : {State::autonomy, State::hold, State::lost}) {
    EXPECT_FALSE(attends(state, false)) << to_string(state);
    EXPECT_TRUE(attends(state, true)) << to_string(state);  // lost while in control
  }
}

}  // namespace
}  // namespace hidwa_local_planner::input
