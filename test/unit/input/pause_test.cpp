// SPDX-License-Identifier: BSD-3-Clause
// The planner itself stands still, while the person goes on: what was not heard is not held against the device.
#include <string>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kPeriod = 0.05;  // of cycles, messages and the listener's words [s]

/// Cycles, a listener and a stick, all at 20 Hz. The stick has been deflected for a second.
struct Steering : Person {
  Steering() {
    machine.heartbeat(now);
    run(0.5, 0.0F);
    EXPECT_EQ(run(1.0, 1.0F), State::shared);
  }
  State run(double seconds, float angular) {
    const int count = static_cast<int>(seconds / kPeriod + 0.5);
    for (int i = 0; i < count; ++i) {
      machine.heartbeat(now += kPeriod);
      cycle_with_stick(now, angular);
    }
    return machine.state();
  }
  /// Nothing is at work for `seconds`, until a cycle.
  State wake_after(double seconds) { return cycle(now += seconds).state; }

  double now = 100.0;  // [s]
};

TEST(PauseDetector, TellsOfWhatAnybodyNotices) {
  PauseDetector pauses;
  pauses.report(0.29, 10.0);
  EXPECT_EQ(pauses.advice(10.0), "");
  pauses.report(0.3, 10.0);
  EXPECT_TRUE(says(pauses.advice(10.0), "paused for 0.3 s"));
  EXPECT_NE(pauses.advice(19.99), "");
  EXPECT_EQ(pauses.advice(20.0), "");  // told of for 10 s
}

TEST(Pause, IsNoSilenceWhoWakesUpFirst) {
  for (const bool message_first : {true, false}) {
    Steering planner;
    planner.now += 0.62;  // more than input_timeout
    EXPECT_TRUE(planner.machine.paused_since_last_cycle(planner.now));
    if (message_first) planner.stick(planner.now, 1.0F);
    EXPECT_TRUE(planner.machine.paused_since_last_cycle(planner.now));
    expect_shared(planner.cycle(planner.now), 0.5, 1.0);
    EXPECT_FALSE(planner.machine.paused_since_last_cycle(planner.now));
    EXPECT_EQ(planner.run(0.5, 1.0F), State::shared);
  }
}

// Only the longest pause since the last message is excused, so that pauses without end keep nothing alive.
TEST(Pause, AfterPauseWithoutAMessageIsALossButOfOurOwn) {
  Steering planner;
  EXPECT_EQ(planner.wake_after(0.3), State::shared);
  EXPECT_EQ(planner.wake_after(0.4), State::shared);  // 0.7 - 0.4 = 0.3 s of silence
  EXPECT_EQ(planner.wake_after(0.4), State::lost);    // 1.1 - 0.4 = 0.7 s
  EXPECT_TRUE(planner.machine.lost_by_pauses(planner.now));
  EXPECT_EQ(planner.run(kPeriod, 1.0F), State::shared);  // no neutral
  EXPECT_FALSE(planner.machine.lost_by_pauses(planner.now));
}

// The host drove by itself, or nobody had a goal: messages could be heard all the time, and none came.
TEST(Pause, OfTheCyclesAloneIsNone) {
  Steering planner;
  for (int i = 0; i < 20; ++i) planner.machine.heartbeat(planner.now += kPeriod);
  EXPECT_EQ(planner.cycle(planner.now).state, State::lost);
  EXPECT_EQ(planner.run(1.0, 1.0F), State::lost);
}

// A listener that hangs for ever, and a host so slow that each of its cycles looks like a pause.
TEST(Pause, OfAListenerThatHangsKeepsNothingAlive) {
  Steering planner;
  const double heard = planner.now;
  State state = State::shared;
  while (state == State::shared && planner.now < heard + 10.0) state = planner.cycle(planner.now += 0.2).state;
  EXPECT_EQ(state, State::lost);
  EXPECT_LE(planner.now - heard, 0.5 + 0.2 + 0.2 + 1e-9);  // input_timeout, a pause, a cycle
}

TEST(Pause, IsNamedInsteadOfTheLink) {
  Steering planner;
  planner.wake_after(0.62);
  const std::string advice = planner.machine.advice();
  EXPECT_TRUE(says(advice, "The planner itself was paused for 0.62 s")) << advice;
  EXPECT_FALSE(says(advice, "link")) << advice;
  EXPECT_FALSE(says(advice, "fell silent")) << advice;
  planner.run(11.0, 1.0F);
  EXPECT_EQ(planner.machine.advice(), "");
}

TEST(Pause, OfAHandAndItsClutch) {
  Person person(in_mode(OperatorMode::gesture));
  double now = 100.0;
  const auto step = [&](double seconds, bool held, double y) {
    now += seconds;
    person.machine.heartbeat(now);
    held ? person.button(now, 0) : person.stick(now, 0.0F);
    person.hand(now, y);
    return person.cycle(now).state;
  };
  step(kPeriod, false, 0.0);
  step(kPeriod, true, 0.0);
  ASSERT_EQ(step(kPeriod, true, 0.2), State::shared);
  EXPECT_EQ(person.cycle(now += 0.8).state, State::shared);
  EXPECT_EQ(step(kPeriod, true, 0.2), State::shared);  // the origin is still the same
}

TEST(Pause, IsKeptByAnArchive) {
  Steering planner;
  planner.wake_after(0.3);
  Person other(planner.p);
  load(other.machine, saved(planner.machine));
  for (const double later : {0.4, 0.8}) {
    EXPECT_EQ(other.machine.update(planner.now + later).state, planner.machine.update(planner.now + later).state)
        << later;
    EXPECT_EQ(other.machine.lost_by_pauses(planner.now + later), planner.machine.lost_by_pauses(planner.now + later));
  }
  EXPECT_EQ(other.machine.state(), State::lost);
}

}  // namespace
}  // namespace hidwa_local_planner::input
