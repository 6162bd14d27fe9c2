// SPDX-License-Identifier: BSD-3-Clause
// Mode switching: who has control, and what the person's control is.
#include <string>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

Parameters switching() { return in_mode(OperatorMode::switching); }

/// Someone who has taken control by the button; the last message and the last cycle are at 1 s.
struct InControl : Person {
  explicit InControl(const Parameters& parameters = switching()) : Person(parameters) {
    cycle_with_stick(0.7, 0.0F);
    cycle_with_button(0.95, kToggle);
    EXPECT_EQ(cycle_with_stick(1.0, 0.0F).state, State::manual);
    EXPECT_TRUE(machine.manual());
  }
};

TEST(Manual, BothAxesThroughTheMap) {
  InControl person;
  expect_manual(person.cycle_with_stick(1.05, 1.0F, 1.0F), 0.5, 1.0);      // 1^2 * 0.5, 1^2 * 1
  expect_manual(person.cycle_with_stick(1.1, -0.5F, 0.5F), 0.125, -0.25);  // 0.5^2 * 0.5, -(0.5^2) * 1
  // Pulling back is no stop here, and u_h is not clipped.
  expect_manual(person.cycle_with_stick(1.15, 0.0F, -1.0F), -0.5, 0.0);
  // |p| <= 0.1 is none, on each axis by itself.
  expect_manual(person.cycle_with_stick(1.2, 0.1F, 1.0F), 0.5, 0.0);
  expect_manual(person.cycle_with_stick(1.25, 1.0F, -0.1F), 0.0, 1.0);
}

TEST(Manual, NoInputIsZero) {
  InControl person;
  expect_manual(person.cycle(1.05), 0.0, 0.0);
  person.cycle_with_stick(1.1, 1.0F, 1.0F);
  expect_manual(person.cycle_with_stick(1.15, 0.0F), 0.0, 0.0);  // let go: no hold
  expect_manual(person.cycle(60.0), 0.0, 0.0);                   // a centred stick may be silent
}

TEST(Manual, EachPressHandsControlOver) {
  InControl person;
  EXPECT_EQ(person.cycle_with_button(1.05, kToggle).state, State::autonomy);
  EXPECT_FALSE(person.machine.manual());
  EXPECT_EQ(person.cycle_with_button(1.1, kToggle).state, State::autonomy);  // still held: not another press
  person.stick(1.15, 0.0F);
  EXPECT_EQ(person.cycle_with_button(1.2, kToggle).state, State::manual);
}

TEST(Manual, AButtonHeldAtTheStartIsNoPress) {
  Person person(switching());
  person.cycle(1.0);
  EXPECT_EQ(person.cycle_with_button(1.05, kToggle).state, State::autonomy);
  person.stick(1.3, 0.0F);
  EXPECT_EQ(person.cycle_with_button(1.35, kToggle).state, State::manual);
}

TEST(Manual, APressWhileNoCycleRunsHasNoEffect) {
  Person person(switching());
  person.stick(1.0, 0.0F);
  person.button(1.3, kToggle);  // no goal yet, no cycle
  EXPECT_EQ(person.cycle(1.35).state, State::autonomy);
  for (double time = 1.4; time < 4.0; time += 0.05) person.stick(time, 0.0F);
  person.button(4.0, kToggle);  // 2.65 s after the last cycle
  person.stick(4.05, 0.0F);
  EXPECT_EQ(person.cycle(4.1).state, State::autonomy);
  for (double time = 4.15; time < 5.0; time += 0.05) person.stick(time, 0.0F);
  person.button(5.0, kToggle);  // 0.9 s after it
  EXPECT_EQ(person.cycle(5.2).state, State::manual);
}

TEST(Manual, AHeldButtonOfAnotherDeviceIsNoPress) {
  const std::string other = "/another_joy_node";
  Person person(switching());
  person.cycle_with_stick(1.0, 0.0F);
  EXPECT_EQ(person.cycle_with(from(other, button_at(1.3, kToggle))).state, State::autonomy);
  person.machine.receive(from(other, stick_at(1.35, 0.0F)));
  EXPECT_EQ(person.cycle_with(from(other, button_at(1.4, kToggle))).state, State::manual);
}

TEST(Manual, AnotherDeviceMustBeSeenCentredAndLeavesControlAlone) {
  const std::string other = "/another_joy_node";
  InControl person;
  person.cycle_with_stick(1.05, 1.0F, 1.0F);
  expect_manual(person.cycle_with(from(other, stick_at(1.1, 1.0F, 1.0F))), 0.0, 0.0);
  person.machine.receive(from(other, stick_at(1.15, 0.0F)));
  expect_manual(person.cycle_with(from(other, stick_at(1.2, 1.0F, 1.0F))), 0.5, 1.0);
}

TEST(Manual, LostInputBrakesWhateverThePolicyUntilItReturnsCentred) {
  for (const OnInputLost policy : {OnInputLost::hold, OnInputLost::stop, OnInputLost::autonomy}) {
    InControl person(with_policy(policy, OperatorMode::switching));
    person.stick(1.05, 1.0F, 1.0F);
    expect_manual(person.cycle(1.54), 0.5, 1.0);  // 0.49 s
    expect_lost(person.cycle(1.56), Influence::stop);
    expect_lost(person.cycle(100.0), Influence::stop);
    expect_lost(person.cycle_with_stick(100.05, 1.0F, 1.0F), Influence::stop);
    EXPECT_TRUE(person.machine.manual());
    expect_manual(person.cycle_with_stick(100.1, 0.0F), 0.0, 0.0);
    expect_manual(person.cycle_with_stick(100.15, 1.0F, 1.0F), 0.5, 1.0);
  }
}

TEST(Manual, ALossEndsWithTheModeAndWhenControlIsGivenBackInWords) {
  for (const bool in_words : {false, true}) {
    InControl person;
    person.cycle_with_stick(1.05, 1.0F, 1.0F);
    EXPECT_EQ(person.cycle(1.6).state, State::lost);
    if (in_words) {
      person.machine.take_control(false);
    } else {
      person.set_mode(OperatorMode::joystick);
    }
    expect_autonomy(person.cycle(1.65));
  }
}

TEST(Manual, AChangeOfModeGivesControlBack) {
  InControl person;
  person.cycle_with_stick(1.05, 1.0F, 1.0F);
  person.set_mode(OperatorMode::joystick);
  EXPECT_FALSE(person.machine.manual());
  EXPECT_EQ(person.cycle_with_stick(1.1, 1.0F, 1.0F).state, State::autonomy);  // not seen centred
  EXPECT_EQ(person.steer(1.15).state, State::shared);
  person.set_mode(OperatorMode::switching);
  expect_autonomy(person.cycle_with_button(1.25, kToggle, 1.0F));  // held when the mode began: no press
}

TEST(Manual, TuningDoesNotInterrupt) {
  InControl person;
  person.cycle_with_stick(1.05, 0.5F, 0.5F);
  person.p.max_vel_x = 0.4;
  person.configure();
  expect_manual(person.cycle(1.1), 0.1, 0.25);  // 0.5^2 * 0.4
}

TEST(Manual, InWordsWithoutAnyStick) {
  Person person(switching());
  person.cycle(1.0);
  person.machine.take_control(true);
  expect_manual(person.cycle(1.05), 0.0, 0.0);
  person.machine.take_control(true);  // said again: as it is
  EXPECT_EQ(person.cycle(1.1).state, State::manual);
  person.machine.take_control(true);
  person.machine.take_control(false);  // the last word counts
  EXPECT_EQ(person.cycle(1.15).state, State::autonomy);
}

TEST(Manual, InWordsBesideAStickThatSendsOnlyChanges) {
  Parameters p = switching();
  p.input_timeout = 0.0;
  Person person(p);
  person.stick(1.0, 0.0F);
  for (int i = 0; i < 200; ++i) person.cycle(1.0 + 0.05 * i);
  person.machine.take_control(true);  // 10 s after its last message
  EXPECT_EQ(person.cycle(11.0).state, State::manual);
}

TEST(Manual, InWordsWhileNoCycleRunsHasNoEffect) {
  Person person(switching());
  person.machine.take_control(true);
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);  // the first cycle of all
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  person.machine.take_control(true);
  EXPECT_EQ(person.cycle(60.0).state, State::autonomy);  // the next goal, a minute later
  EXPECT_EQ(person.cycle(60.05).state, State::autonomy);
}

TEST(Manual, InWordsOnlyInItsMode) {
  Person person;
  person.cycle(1.0);
  person.machine.take_control(true);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  person.set_mode(OperatorMode::switching);
  person.cycle(1.1);
  EXPECT_EQ(person.cycle(1.15).state, State::autonomy);
}

TEST(Manual, WithoutAToggleButtonNoButtonTakesControl) {
  Parameters p = switching();
  p.toggle_button = -1;
  Person person(p);
  person.cycle_with_stick(1.0, 0.0F);
  EXPECT_EQ(person.cycle_with_button(1.3, kToggle).state, State::autonomy);
}

TEST(Manual, AnotherToggleButtonThatIsHeldIsNoPress) {
  Person person(switching());
  person.cycle_with_stick(1.0, 0.0F);
  person.button(1.3, 1);
  person.p.toggle_button = 1;
  person.configure();
  EXPECT_EQ(person.cycle_with_button(1.35, 1).state, State::autonomy);
  person.stick(1.4, 0.0F);
  EXPECT_EQ(person.cycle_with_button(1.45, 1).state, State::manual);
}

TEST(Manual, EnableButton) {
  Parameters p = switching();
  p.enable_button = 1;
  InControl person(p);
  expect_manual(person.cycle_with_stick(1.05, 1.0F, 1.0F), 0.0, 0.0);  // deflected, not enabled
  expect_manual(person.cycle_with_button(1.1, 1, 1.0F, 1.0F), 0.5, 1.0);
  expect_manual(person.cycle_with_button(1.15, 1), 0.0, 0.0);  // centred is zero, not straight on
  EXPECT_EQ(person.cycle(1.7).state, State::lost);             // but held, so its silence is a loss
}

}  // namespace
}  // namespace hidwa_local_planner::input
