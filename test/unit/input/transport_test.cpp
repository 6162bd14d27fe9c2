// SPDX-License-Identifier: BSD-3-Clause
// What happens to messages on their way: they are held back, their clock is another one, their sender changes.
#include <string>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

TEST(Transport, ARepeaterThatDoesNotRefreshItsStampSteers) {
  Person person;
  person.machine.receive(stamped(1.0, stick_at(1.0, 0.0F)));
  for (int i = 1; i < 200; ++i) {
    EXPECT_EQ(person.cycle_with(stamped(1.05, stick_at(1.0 + 0.05 * i, 1.0F))).state, State::shared);
  }
  EXPECT_EQ(person.machine.dropped(), 0U);
}

TEST(Transport, ASendersClockThatWasSetBackIsLearntAndTheStickMustBeSeenCentred) {
  Person person;
  person.machine.receive(stamped(100.0, stick_at(1.0, 0.0F)));
  EXPECT_EQ(person.cycle_with(stamped(100.05, stick_at(1.05, 1.0F))).state, State::shared);
  for (int i = 0; i < 120; ++i) {
    const double now = 1.1 + 0.05 * i;
    person.machine.receive(stamped(3.0 + 0.05 * i, stick_at(now + 1e-6 * i, 1.0F)));
    EXPECT_EQ(person.cycle(now + 1e-3).state, now <= 1.52 ? State::shared : State::lost) << now;
  }
  EXPECT_EQ(person.machine.dropped(), 100U);  // 5 s at 20 Hz
  person.machine.receive(stamped(9.0, stick_at(7.1, 0.0F)));
  EXPECT_EQ(person.cycle_with(stamped(9.05, stick_at(7.15, -1.0F))).state, State::shared);
}

TEST(Transport, ADeviceOfAnotherShapeOrSenderMustBeSeenCentred) {
  const auto wide = [](double time, float angular) {
    StickMessage message = stick_at(time, angular);
    message.buttons.push_back(0);
    return message;
  };
  Person person;
  person.steer(1.0);
  EXPECT_EQ(person.cycle_with(wide(1.1, 1.0F)).state, State::hold);
  person.machine.receive(wide(1.15, 0.0F));
  EXPECT_EQ(person.cycle_with(wide(1.2, 1.0F)).state, State::shared);
  EXPECT_EQ(person.cycle_with(from("/another_joy_node", wide(1.25, 1.0F))).state, State::hold);
}

TEST(Transport, TwoSendersInTurnSteerNothingAndAreNamed) {
  Person person;
  for (int i = 0; i < 20; ++i) {
    const double time = 1.0 + 0.05 * i;
    EXPECT_EQ(person.cycle_with(from("/here", stick_at(time, 1.0F))).state, State::autonomy);
    EXPECT_EQ(person.cycle_with(from("/there", stick_at(time + 0.02, 0.0F))).state, State::autonomy);
  }
  EXPECT_TRUE(says(person.machine.advice(), "/here and /there")) << person.machine.advice();
  // One of them goes.
  for (int i = 0; i < 100; ++i) person.machine.receive(from("/there", stick_at(2.0 + 0.05 * i, 0.0F)));
  EXPECT_EQ(person.machine.advice(), "");
  EXPECT_EQ(person.cycle_with(from("/there", stick_at(7.0, 1.0F))).state, State::shared);
}

TEST(Transport, ASenderThatTakesOverIsNoRival) {
  Person person;
  for (int i = 0; i < 100; ++i) person.machine.receive(from("/here", stick_at(1.0 + 0.05 * i, 0.0F)));
  for (int i = 0; i < 100; ++i) person.machine.receive(from("/there", stick_at(6.0 + 0.05 * i, 0.0F)));
  person.machine.receive(from("/here", stick_at(11.0, 0.0F)));
  EXPECT_EQ(person.machine.advice(), "");
}

TEST(Transport, AStickThatSendsOnlyChangesIsReportedWithTheRemedyInBothModes) {
  for (const OperatorMode mode : {OperatorMode::joystick, OperatorMode::switching}) {
    Person person(in_mode(mode));
    person.cycle_with_stick(1.0, 0.0F);
    person.machine.take_control(true);
    person.cycle(1.02);
    person.cycle_with_stick(1.05, 1.0F);
    EXPECT_EQ(person.machine.advice(), "");
    EXPECT_EQ(person.cycle(1.6).state, State::lost);
    for (const char* part : {"sends only changes", "autorepeat_rate to 20", "input_timeout to 0"}) {
      EXPECT_TRUE(says(person.machine.advice(), part)) << person.machine.advice();
    }
    person.stick(2.0, 0.0F);
    EXPECT_EQ(person.machine.advice(), "");
  }
}

TEST(Transport, TheReportGoesAwayWithTheRemedy) {
  Person person;
  person.steer(1.0);
  person.cycle(1.6);
  EXPECT_TRUE(says(person.machine.advice(), "fell silent"));
  person.p.input_timeout = 0.0;
  person.configure();
  EXPECT_FALSE(says(person.machine.advice(), "fell silent"));
}

TEST(Transport, ThreadsMayReadTheClockOutOfTurn) {
  Person person;
  person.steer(1.0);
  person.stick(1.101, 1.0F);
  EXPECT_EQ(person.cycle(1.1).state, State::shared);
  EXPECT_DOUBLE_EQ(person.machine.input_age(1.1), 0.0);
  person.stick(1.099, 1.0F);
  EXPECT_EQ(person.cycle(1.098).state, State::shared);
}

}  // namespace
}  // namespace hidwa_local_planner::input
