// SPDX-License-Identifier: BSD-3-Clause
// Mode switching: who has control where devices, buttons and parameters change. With one stick: twin_test.cpp.
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

TEST(Manual, ALossEndsWithTheMode) {
  InControl person;
  person.cycle_with_stick(1.05, 1.0F, 1.0F);
  EXPECT_EQ(person.cycle(1.6).state, State::lost);
  person.set_mode(OperatorMode::joystick);
  expect_autonomy(person.cycle(1.65));
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
