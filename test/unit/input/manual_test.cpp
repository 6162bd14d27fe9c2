// SPDX-License-Identifier: BSD-3-Clause
// Mode switching: who has control, and what the person's control is.
#include <cmath>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;
constexpr std::size_t kToggle = 0;

Parameters switching() {
  Parameters p;  // max_vel_x 0.5, max_vel_theta 1
  p.mode = OperatorMode::switching;
  return p;
}

/// Control taken by the button; the last message and the last cycle are at `time` [s].
void take(Person& person, double time) {
  person.stick(time - 0.3, 0.0F);
  person.cycle(time - 0.3);
  person.button(time - 0.05, kToggle);
  person.cycle(time - 0.05);
  person.stick(time, 0.0F);
  EXPECT_EQ(person.cycle(time).state, State::manual);
  EXPECT_TRUE(person.machine.manual());
}

void expect_manual(const OperatorIntent& intent, double v, double omega) {
  expect_intent(intent, State::manual, Influence::direct, v, omega);
}

TEST(Manual, BothAxesThroughTheMap) {
  Person person(switching());
  take(person, 1.0);
  person.stick(1.05, 1.0F, 1.0F);
  expect_manual(person.cycle(1.05), 0.5, 1.0);  // 1^2 * 0.5, 1^2 * 1
  person.stick(1.1, -0.5F, 0.5F);
  expect_manual(person.cycle(1.1), 0.125, -0.25);  // 0.5^2 * 0.5, -(0.5^2) * 1
  person.stick(1.15, 0.0F, -1.0F);
  expect_manual(person.cycle(1.15), -0.5, 0.0);  // pulling back is no stop here; u_h is not clipped
  person.stick(1.2, 0.1F, 1.0F);
  expect_manual(person.cycle(1.2), 0.5, 0.0);  // |p| <= 0.1 is none, on each axis by itself
  person.stick(1.25, 1.0F, -0.1F);
  expect_manual(person.cycle(1.25), 0.0, 1.0);
  const float above = std::nextafter(0.1F, 1.0F);
  person.stick(1.3, above, -above);
  const OperatorIntent least = person.cycle(1.3);
  EXPECT_NEAR(least.u_h.omega, 0.01, 1e-8);  // 0.1^2
  EXPECT_NEAR(least.u_h.v, -0.005, 1e-8);    // -(0.1^2) * 0.5
}

TEST(Manual, NoInputIsZero) {
  Person person(switching());
  take(person, 1.0);
  expect_manual(person.cycle(1.05), 0.0, 0.0);
  person.stick(1.1, 1.0F, 1.0F);
  person.cycle(1.1);
  person.stick(1.15, 0.0F);  // let go: no hold
  expect_manual(person.cycle(1.15), 0.0, 0.0);
  expect_manual(person.cycle(60.0), 0.0, 0.0);  // a centred stick may be silent
}

TEST(Manual, TheGuardIsHandedOn) {
  Parameters p = switching();
  Person guarded(p);
  take(guarded, 1.0);
  EXPECT_TRUE(guarded.cycle(1.05).guarded);
  p.guard = Guard::none;
  Person bare(p);
  take(bare, 1.0);
  EXPECT_FALSE(bare.cycle(1.05).guarded);
}

TEST(Manual, WithoutControlTheStickIsNoInput) {
  Person person(switching());
  person.steer(1.0, 1.0F, 1.0F);
  expect_intent(person.cycle(1.1), State::autonomy, Influence::none, 0.0, 0.0);
  expect_intent(person.cycle(5.0), State::autonomy, Influence::none, 0.0, 0.0);  // nor is its silence a loss
}

TEST(Manual, EachPressHandsControlOver) {
  Person person(switching());
  take(person, 1.0);
  person.button(1.05, kToggle);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  EXPECT_FALSE(person.machine.manual());
  person.button(1.1, kToggle);  // still held: not another press
  EXPECT_EQ(person.cycle(1.1).state, State::autonomy);
  person.stick(1.15, 0.0F);
  person.button(1.2, kToggle);
  EXPECT_EQ(person.cycle(1.2).state, State::manual);
}

TEST(Manual, GivingItBackLeavesNoHold) {
  Person person(switching());
  take(person, 1.0);
  person.stick(1.05, 1.0F, 1.0F);
  person.cycle(1.05);
  person.button(1.1, kToggle, 1.0F, 1.0F);
  expect_intent(person.cycle(1.1), State::autonomy, Influence::none, 0.0, 0.0);
}

TEST(Manual, AButtonHeldAtTheStartIsNoPress) {
  Person person(switching());
  person.cycle(1.0);
  person.button(1.05, kToggle);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  person.stick(1.3, 0.0F);
  person.button(1.35, kToggle);
  EXPECT_EQ(person.cycle(1.35).state, State::manual);
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
  Person person(switching());
  person.stick(1.0, 0.0F);
  person.cycle(1.0);
  StickMessage other = stick_at(1.3, 0.0F);
  other.sender = "/another_joy_node";
  other.buttons = {1, 0};
  person.machine.receive(other);
  EXPECT_EQ(person.cycle(1.3).state, State::autonomy);
  other.received = 1.35;
  other.buttons = {0, 0};
  person.machine.receive(other);
  other.received = 1.4;
  other.buttons = {1, 0};
  person.machine.receive(other);
  EXPECT_EQ(person.cycle(1.4).state, State::manual);
}

TEST(Manual, AnotherDeviceMustBeSeenCentredAndLeavesControlAlone) {
  Person person(switching());
  take(person, 1.0);
  person.stick(1.05, 1.0F, 1.0F);
  person.cycle(1.05);
  StickMessage other = stick_at(1.1, 1.0F, 1.0F);
  other.sender = "/another_joy_node";
  person.machine.receive(other);
  expect_manual(person.cycle(1.1), 0.0, 0.0);
  other.received = 1.15;
  other.axes = {0.0F, 0.0F};
  person.machine.receive(other);
  other.received = 1.2;
  other.axes = {1.0F, 1.0F};
  person.machine.receive(other);
  expect_manual(person.cycle(1.2), 0.5, 1.0);
}

TEST(Manual, ADeflectedStickAtTheStartMustBeSeenCentred) {
  Person person(switching());
  person.stick(1.0, 1.0F, 1.0F);
  person.cycle(1.0);
  person.button(1.3, kToggle, 1.0F, 1.0F);
  expect_manual(person.cycle(1.3), 0.0, 0.0);
  person.stick(1.35, 0.0F);
  person.stick(1.4, 1.0F, 1.0F);
  expect_manual(person.cycle(1.4), 0.5, 1.0);
}

TEST(Manual, LostInputBrakesWhateverThePolicyUntilItReturnsCentred) {
  for (const OnInputLost policy : {OnInputLost::hold, OnInputLost::stop, OnInputLost::autonomy}) {
    Parameters p = switching();
    p.on_input_lost = policy;
    Person person(p);
    take(person, 1.0);
    person.stick(1.05, 1.0F, 1.0F);
    expect_manual(person.cycle(1.54), 0.5, 1.0);  // 0.49 s
    expect_intent(person.cycle(1.56), State::lost, Influence::stop, 0.0, 0.0);
    expect_intent(person.cycle(100.0), State::lost, Influence::stop, 0.0, 0.0);
    person.stick(100.05, 1.0F, 1.0F);
    expect_intent(person.cycle(100.05), State::lost, Influence::stop, 0.0, 0.0);
    EXPECT_TRUE(person.machine.manual());
    person.stick(100.1, 0.0F);
    expect_manual(person.cycle(100.1), 0.0, 0.0);
    person.stick(100.15, 1.0F, 1.0F);
    expect_manual(person.cycle(100.15), 0.5, 1.0);
  }
}

TEST(Manual, ALossEndsWithTheMode) {
  Person person(switching());
  take(person, 1.0);
  person.stick(1.05, 1.0F, 1.0F);
  person.cycle(1.05);
  EXPECT_EQ(person.cycle(1.6).state, State::lost);
  person.p.mode = OperatorMode::joystick;
  person.machine.configure(person.p);
  expect_intent(person.cycle(1.65), State::autonomy, Influence::none, 0.0, 0.0);
}

TEST(Manual, ALossEndsWhenControlIsGivenBackInWords) {
  Person person(switching());
  take(person, 1.0);
  person.stick(1.05, 1.0F, 1.0F);
  person.cycle(1.05);
  EXPECT_EQ(person.cycle(1.6).state, State::lost);
  person.machine.take_control(false);
  expect_intent(person.cycle(1.65), State::autonomy, Influence::none, 0.0, 0.0);
}

TEST(Manual, AGoalLatchDoesNotTakeControl) {
  Person person(switching());
  CycleFeedback latched;
  latched.goal_latched = true;
  take(person, 1.0);
  person.stick(1.05, 1.0F, 1.0F);
  expect_manual(person.cycle(1.05, latched), 0.5, 1.0);
  person.stick(1.1, 1.0F, 1.0F);
  expect_manual(person.cycle(1.1, latched), 0.5, 1.0);
  person.button(1.15, kToggle);
  EXPECT_EQ(person.cycle(1.15, latched).state, State::autonomy);
  person.stick(1.2, 0.0F);
  person.button(1.25, kToggle);
  EXPECT_EQ(person.cycle(1.25, latched).state, State::manual);  // nor keeps it from being taken
}

TEST(Manual, ANewGoalLeavesControl) {
  Person person(switching());
  take(person, 1.0);
  person.stick(1.05, 1.0F, 1.0F);
  person.cycle(1.05);
  person.machine.new_goal();
  person.stick(1.1, 1.0F, 1.0F);
  expect_manual(person.cycle(1.1), 0.5, 1.0);
}

TEST(Manual, RejectionsDoNotMakeItBlocked) {
  Parameters p = switching();
  p.blocked_time = 0.0;
  Person person(p);
  take(person, 1.0);
  CycleFeedback rejected;
  rejected.operator_command_rejected = rejected.stands = true;
  person.stick(1.05, 1.0F, 1.0F);
  EXPECT_EQ(person.cycle(1.05, rejected).state, State::manual);
  EXPECT_EQ(person.cycle(1.1, rejected).state, State::manual);
}

TEST(Manual, ControlIsHandedOverBeneathAStop) {
  Parameters p = switching();
  p.stop_button = 1;
  Person person(p);
  person.stick(1.0, 0.0F);
  person.machine.stop(true);
  EXPECT_EQ(person.cycle(1.0).state, State::stopped);
  person.button(1.3, kToggle);
  EXPECT_EQ(person.cycle(1.3).state, State::stopped);
  EXPECT_TRUE(person.machine.manual());
  person.machine.stop(false);
  expect_manual(person.cycle(1.35), 0.0, 0.0);
}

TEST(Manual, AChangeOfModeGivesControlBack) {
  Person person(switching());
  take(person, 1.0);
  person.stick(1.05, 1.0F, 1.0F);
  person.cycle(1.05);
  person.p.mode = OperatorMode::joystick;
  person.machine.configure(person.p);
  EXPECT_FALSE(person.machine.manual());
  person.stick(1.1, 1.0F, 1.0F);
  EXPECT_EQ(person.cycle(1.1).state, State::autonomy);  // not seen centred
  person.stick(1.15, 0.0F);
  person.stick(1.2, 1.0F);
  EXPECT_EQ(person.cycle(1.2).state, State::shared);
  person.p.mode = OperatorMode::switching;
  person.machine.configure(person.p);
  person.button(1.25, kToggle, 1.0F);  // held when the mode began: no press
  expect_intent(person.cycle(1.25), State::autonomy, Influence::none, 0.0, 0.0);
}

TEST(Manual, TuningDoesNotInterrupt) {
  Person person(switching());
  take(person, 1.0);
  person.stick(1.05, 0.5F, 0.5F);
  person.cycle(1.05);
  person.p.max_vel_x = 0.4;
  person.machine.configure(person.p);
  expect_manual(person.cycle(1.1), 0.1, 0.25);  // 0.5^2 * 0.4
}

TEST(Manual, InWordsWithoutAnyStick) {
  Person person(switching());
  person.cycle(1.0);
  person.machine.take_control(true);
  expect_manual(person.cycle(1.05), 0.0, 0.0);
  person.machine.take_control(true);  // said again: as it is
  EXPECT_EQ(person.cycle(1.1).state, State::manual);
  person.machine.take_control(false);
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

TEST(Manual, InWordsTheLastOneCounts) {
  Person person(switching());
  person.cycle(1.0);
  person.machine.take_control(true);
  person.machine.take_control(false);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
}

TEST(Manual, InWordsOnlyInItsMode) {
  Person person;
  person.cycle(1.0);
  person.machine.take_control(true);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  person.p.mode = OperatorMode::switching;
  person.machine.configure(person.p);
  person.cycle(1.1);
  EXPECT_EQ(person.cycle(1.15).state, State::autonomy);
}

TEST(Manual, WithoutAToggleButtonNoButtonTakesControl) {
  Parameters p = switching();
  p.toggle_button = -1;
  Person person(p);
  person.stick(1.0, 0.0F);
  person.cycle(1.0);
  person.button(1.3, kToggle);
  EXPECT_EQ(person.cycle(1.3).state, State::autonomy);
}

TEST(Manual, AnotherToggleButtonThatIsHeldIsNoPress) {
  Person person(switching());
  person.stick(1.0, 0.0F);
  person.cycle(1.0);
  person.button(1.3, 1);
  person.p.toggle_button = 1;
  person.machine.configure(person.p);
  person.button(1.35, 1);
  EXPECT_EQ(person.cycle(1.35).state, State::autonomy);
  person.stick(1.4, 0.0F);
  person.button(1.45, 1);
  EXPECT_EQ(person.cycle(1.45).state, State::manual);
}

TEST(Manual, EnableButton) {
  Parameters p = switching();
  p.enable_button = 1;
  Person person(p);
  take(person, 1.0);
  person.stick(1.05, 1.0F, 1.0F);
  expect_manual(person.cycle(1.05), 0.0, 0.0);  // deflected, not enabled
  person.button(1.1, 1, 1.0F, 1.0F);
  expect_manual(person.cycle(1.1), 0.5, 1.0);
  person.button(1.15, 1);
  expect_manual(person.cycle(1.15), 0.0, 0.0);      // centred is zero, not straight on
  EXPECT_EQ(person.cycle(1.7).state, State::lost);  // but held, so its silence is a loss
}

TEST(Manual, WhatTheDeviceLacksIsNamedWithTheRemedy) {
  Parameters p = switching();
  p.axis_linear = {4};
  EXPECT_EQ(Person(p).stick(1.0, 0.0F),
            "axis_linear = 4, but the message has only axes 0 to 1: set axis_linear to one that the device has");
  p = switching();
  p.toggle_button = 7;
  EXPECT_EQ(Person(p).stick(1.0, 0.0F),
            "toggle_button = 7, but the message has only buttons 0 to 1: set toggle_button to one that the device "
            "has, or to -1 for none");
  Person person(switching());
  EXPECT_EQ(person.stick(1.0, 0.0F, 1.5F),
            "axes[1] = 1.5 is outside [-1, 1]: scale it at the sender, or set axis_linear to another axis");
  StickMessage message = stick_at(1.0, 0.0F);
  message.buttons[kToggle] = 2;
  EXPECT_EQ(person.machine.receive(message),
            "buttons[0] = 2 is neither 0 nor 1: look at the sender, or set toggle_button to another button");
  EXPECT_EQ(person.machine.dropped(), 2U);
}

TEST(Manual, BadMessagesWhileItLastsHaveNoEffect) {
  Person person(switching());
  take(person, 1.0);
  person.stick(1.05, 0.5F, 1.0F);
  person.cycle(1.05);
  EXPECT_NE(person.stick(1.1, 0.0F, 7.0F), "");
  StickMessage message = stick_at(1.1, 0.0F);
  message.buttons = {9, 0};
  EXPECT_NE(person.machine.receive(message), "");
  expect_manual(person.cycle(1.1), 0.5, 0.25);
  EXPECT_EQ(person.machine.dropped(), 2U);
}

}  // namespace
}  // namespace hidwa_local_planner::input
