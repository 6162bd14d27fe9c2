// SPDX-License-Identifier: BSD-3-Clause
// The clock is set back, by as little as 0.25 s: steering and holding end, a stop goes on, whoever has control keeps
// it.
#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kBack = 0.25;  // [s]

TEST(ClockSetBack, EndsSteeringUntilTheStickWasSeenCentred) {
  for (const bool in_a_message : {true, false}) {
    Person person;
    person.steer(100.0);
    EXPECT_EQ(person.cycle(100.1).state, State::shared);
    if (in_a_message) person.stick(100.1 - kBack, 1.0F);
    expect_autonomy(person.cycle(100.1 - kBack));
    EXPECT_EQ(person.cycle_with_stick(99.9, 1.0F).state, State::autonomy);
    EXPECT_EQ(person.steer(99.95).state, State::shared);
  }
}

TEST(ClockSetBack, InAMessageEndsSteeringBeforeTheNextCycle) {
  Person person;
  person.steer(100.0);
  person.stick(1.0, 1.0F);
  EXPECT_EQ(person.machine.state(), State::autonomy);
}

TEST(ClockSetBack, BehindAnOldMessageEndsSteeringToo) {
  Parameters p;
  p.input_timeout = 0.0;
  Person person(p);
  person.steer(50.0);
  EXPECT_EQ(person.cycle(100.0).state, State::shared);
  EXPECT_EQ(person.cycle(60.0).state, State::autonomy);
}

TEST(ClockSetBack, AMessageOfBeforeThatNoCycleHasSeenIsForgotten) {
  Person person;
  person.stick(100.0, 0.0F);
  person.stick(100.05, 1.0F);
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
  EXPECT_LT(person.machine.input_age(1.0), 0.0);
}

TEST(ClockSetBack, EndsHold) {
  Person person;
  person.steer(100.0);
  EXPECT_EQ(person.cycle_with_stick(100.1, 0.0F).state, State::hold);
  EXPECT_EQ(person.cycle(100.1 - kBack).state, State::autonomy);
}

TEST(ClockSetBack, AStopGoesOn) {
  for (const bool in_a_message : {true, false}) {
    Person by_button(with_stop_button());
    expect_stopped(by_button.cycle_with_button(100.0, kStop));
    if (in_a_message) by_button.button(100.0 - kBack, kStop);
    expect_stopped(by_button.cycle(100.0 - kBack));
    EXPECT_EQ(by_button.cycle_with_stick(99.8, 0.0F).state, State::autonomy);
  }
  Person by_pull;
  by_pull.stick(99.95, 0.0F);
  expect_stopped(by_pull.cycle_with_stick(100.0, 0.0F, -1.0F));
  expect_stopped(by_pull.cycle(1.0));
  expect_stopped(by_pull.cycle_with_stick(1.05, 0.0F, -0.7F));  // not yet back by a quarter
  Person in_words;
  in_words.machine.stop(true);
  expect_stopped(in_words.cycle(100.0));
  expect_stopped(in_words.cycle(100.0 - kBack));
}

// The stop of a device that dies then still ends in words.
TEST(ClockSetBack, AStopCanStillBeLetGo) {
  Person person(with_stop_button());
  person.cycle_with_button(100.0, kStop);
  expect_stopped(person.cycle(1.0));
  person.machine.stop(false);
  expect_stopped(person.cycle(1.9));
  EXPECT_EQ(person.cycle(2.1).state, State::autonomy);  // 1.1 s after the jump
}

// Mode switching, and the button that hands over control was pressed at 99.5 s; no cycle has seen that yet.
Person who_takes_control() {
  Person person(in_mode(OperatorMode::switching));
  person.cycle_with_stick(99.0, 0.0F);
  person.button(99.5, kToggle);
  return person;
}

TEST(ClockSetBack, ManualBrakesUntilTheStickIsHeardAndCentred) {
  Person person = who_takes_control();
  expect_manual(person.cycle_with_stick(99.55, 1.0F, 1.0F), 0.5, 1.0);
  expect_manual(person.cycle(99.55 - kBack), 0.0, 0.0);
  for (double time = 99.35; time < 99.5; time += 0.05) {
    expect_manual(person.cycle_with_stick(time, 1.0F, 1.0F), 0.0, 0.0);
  }
  person.stick(99.6, 0.0F);
  expect_manual(person.cycle_with_stick(99.65, 1.0F, 1.0F), 0.5, 1.0);
}

// A button that is held all the time is no press, and one that follows is.
TEST(ClockSetBack, ControlIsHandedOverByThePressesThatFollow) {
  Person person = who_takes_control();
  EXPECT_EQ(person.cycle(99.5).state, State::manual);
  EXPECT_EQ(person.cycle(99.5 - kBack).state, State::manual);
  EXPECT_EQ(person.cycle_with_button(99.3, kToggle).state, State::manual);
  for (double time = 99.35; time < 99.8; time += 0.05) {
    EXPECT_EQ(person.cycle_with_stick(time, 0.0F).state, State::manual);
  }
  EXPECT_EQ(person.cycle_with_button(99.85, kToggle).state, State::autonomy);
}

}  // namespace
}  // namespace hidwa_local_planner::input
