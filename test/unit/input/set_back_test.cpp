// SPDX-License-Identifier: BSD-3-Clause
// The clock is set back, by as little as 0.25 s: steering and holding end, a stop goes on, whoever has control keeps
// it.
#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;
constexpr std::size_t kToggle = 0;
constexpr std::size_t kStop = 1;
constexpr double kBack = 0.25;  // [s]

Parameters with_stop() {
  Parameters p;
  p.stop_button = static_cast<int>(kStop);
  return p;
}

TEST(ClockSetBack, EndsSteeringUntilTheStickWasSeenCentred) {
  for (const bool in_a_message : {true, false}) {
    Person person;
    person.steer(100.0);
    EXPECT_EQ(person.cycle(100.1).state, State::shared);
    if (in_a_message) person.stick(100.1 - kBack, 1.0F);
    expect_intent(person.cycle(100.1 - kBack), State::autonomy, Influence::none, 0.0, 0.0);
    person.stick(99.9, 1.0F);
    EXPECT_EQ(person.cycle(99.9).state, State::autonomy);
    person.stick(99.95, 0.0F);
    person.stick(100.0, 1.0F);
    EXPECT_EQ(person.cycle(100.0).state, State::shared);
  }
}

TEST(ClockSetBack, EndsHold) {
  Person person;
  person.steer(100.0);
  person.stick(100.1, 0.0F);
  EXPECT_EQ(person.cycle(100.1).state, State::hold);
  EXPECT_EQ(person.cycle(100.1 - kBack).state, State::autonomy);
}

TEST(ClockSetBack, AStopGoesOn) {
  for (const bool in_a_message : {true, false}) {
    Person by_button(with_stop());
    by_button.button(100.0, kStop);
    EXPECT_EQ(by_button.cycle(100.0).state, State::stopped);
    if (in_a_message) by_button.button(100.0 - kBack, kStop);
    EXPECT_EQ(by_button.cycle(100.0 - kBack).state, State::stopped);
    by_button.stick(99.8, 0.0F);
    EXPECT_EQ(by_button.cycle(99.8).state, State::autonomy);
  }
  Person by_pull;
  by_pull.stick(99.95, 0.0F);
  by_pull.stick(100.0, 0.0F, -1.0F);
  EXPECT_EQ(by_pull.cycle(100.0).state, State::stopped);
  EXPECT_EQ(by_pull.cycle(1.0).state, State::stopped);
  by_pull.stick(1.05, 0.0F, -0.7F);  // not yet back by a quarter
  EXPECT_EQ(by_pull.cycle(1.05).state, State::stopped);
  Person in_words;
  in_words.machine.stop(true);
  EXPECT_EQ(in_words.cycle(100.0).state, State::stopped);
  EXPECT_EQ(in_words.cycle(100.0 - kBack).state, State::stopped);
}

// The stop of a device that dies then still ends in words.
TEST(ClockSetBack, AStopCanStillBeLetGo) {
  Person person(with_stop());
  person.button(100.0, kStop);
  person.cycle(100.0);
  EXPECT_EQ(person.cycle(1.0).state, State::stopped);
  person.machine.stop(false);
  EXPECT_EQ(person.cycle(1.9).state, State::stopped);
  EXPECT_EQ(person.cycle(2.1).state, State::autonomy);  // 1.1 s after the jump
}

// Mode switching, and the button that hands over control was pressed at 99.5 s; no cycle has seen that yet.
Person who_takes_control() {
  Parameters p;
  p.mode = OperatorMode::switching;
  Person person(p);
  person.stick(99.0, 0.0F);
  person.cycle(99.0);
  person.button(99.5, kToggle);
  return person;
}

TEST(ClockSetBack, ManualBrakesUntilTheStickIsHeardAndCentred) {
  Person person = who_takes_control();
  person.stick(99.55, 1.0F, 1.0F);
  expect_intent(person.cycle(99.55), State::manual, Influence::direct, 0.5, 1.0);
  expect_intent(person.cycle(99.55 - kBack), State::manual, Influence::direct, 0.0, 0.0);
  for (double time = 99.35; time < 99.5; time += 0.05) {
    person.stick(time, 1.0F, 1.0F);
    expect_intent(person.cycle(time), State::manual, Influence::direct, 0.0, 0.0);
  }
  person.stick(99.6, 0.0F);
  person.stick(99.65, 1.0F, 1.0F);
  expect_intent(person.cycle(99.65), State::manual, Influence::direct, 0.5, 1.0);
}

// A button that is held all the time is no press, and one that follows is.
TEST(ClockSetBack, ControlIsHandedOverByThePressesThatFollow) {
  Person person = who_takes_control();
  EXPECT_EQ(person.cycle(99.5).state, State::manual);
  EXPECT_EQ(person.cycle(99.5 - kBack).state, State::manual);
  person.button(99.3, kToggle);
  EXPECT_EQ(person.cycle(99.3).state, State::manual);
  for (double time = 99.35; time < 99.8; time += 0.05) {
    person.stick(time, 0.0F);
    EXPECT_EQ(person.cycle(time).state, State::manual);
  }
  person.button(99.85, kToggle);
  EXPECT_EQ(person.cycle(99.85).state, State::autonomy);
}

}  // namespace
}  // namespace hidwa_local_planner::input
