// SPDX-License-Identifier: BSD-3-Clause
// While the host has no goal whoever steers drives, in every mode, with both axes of their device.
#include <gtest/gtest.h>

#include "hidwa_local_planner/core/util/archive.hpp"
#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;

Parameters in_mode(OperatorMode mode) {
  Parameters p;  // max_vel_x 0.5, max_vel_theta 1, linear v_max
  p.mode = mode;
  return p;
}

/// The goal ends while a stick is held there: it must be seen neutral before it drives.
void expect_neutral_first(Person& person, float angular, float linear) {
  person.machine.set_goalless(true);
  person.stick(1.1, angular, linear);
  EXPECT_FALSE(person.machine.steers());
  expect_intent(person.cycle(1.1), State::autonomy, Influence::none, 0.0, 0.0);
  person.stick(1.15, 0.0F);
  person.stick(1.2, 0.0F, 1.0F);
  EXPECT_EQ(person.cycle(1.2).state, State::manual);
}

TEST(WithoutGoal, BothAxesDriveInEveryModeOfTheStick) {
  for (const OperatorMode mode : {OperatorMode::joystick, OperatorMode::switching}) {
    Person person(in_mode(mode));
    person.machine.set_goalless(true);
    person.stick(1.0, 0.0F);
    expect_intent(person.cycle(1.0), State::autonomy, Influence::none, 0.0, 0.0);
    person.stick(1.05, 0.0F, 1.0F);
    EXPECT_TRUE(person.machine.steers());
    expect_intent(person.cycle(1.05), State::manual, Influence::direct, 0.5, 0.0);
    person.stick(1.1, -0.5F, 0.5F);
    expect_intent(person.cycle(1.1), State::manual, Influence::direct, 0.125, -0.25);  // 0.5^2 * 0.5, -(0.5^2) * 1
    person.stick(1.15, 0.0F, 0.0F);
    expect_intent(person.cycle(1.15), State::autonomy, Influence::none, 0.0, 0.0);  // no HOLD
  }
}

TEST(WithoutGoal, AlwaysGuarded) {
  Parameters p = in_mode(OperatorMode::switching);
  p.guard = Guard::none;
  Person person(p);
  person.machine.set_goalless(true);
  EXPECT_TRUE(person.steer(1.0, 0.0F, 1.0F).guarded);
}

TEST(WithoutGoal, ModeOffDrivesNothing) {
  Person person(in_mode(OperatorMode::off));
  person.machine.set_goalless(true);
  expect_intent(person.steer(1.0, 1.0F, 1.0F), State::autonomy, Influence::none, 0.0, 0.0);
}

// With a goal the stick's side alone counts again; a stick that is held forward then asks for nothing.
TEST(WithoutGoal, AGoalComesWhileTheStickIsHeld) {
  Person person(in_mode(OperatorMode::joystick));
  person.machine.set_goalless(true);
  person.steer(1.0, 0.0F, 1.0F);
  person.machine.set_goalless(false);
  EXPECT_EQ(person.cycle(1.1).state, State::autonomy);
  person.stick(1.15, 1.0F, 1.0F);
  expect_intent(person.cycle(1.15), State::shared, Influence::shared, 0.5, 1.0);
}

TEST(WithoutGoal, WhoSteersWhenAGoalEndsMustBeNeutralFirst) {
  Person person(in_mode(OperatorMode::joystick));
  EXPECT_EQ(person.steer(1.0).state, State::shared);
  expect_neutral_first(person, 1.0F, 1.0F);
}

// With a goal a stick that is held straight forward asks for nothing; it does not drive on when the goal ends.
TEST(WithoutGoal, AStickHeldForwardWhenAGoalEndsMustBeNeutralFirst) {
  Person person(in_mode(OperatorMode::joystick));
  person.stick(1.0, 0.0F);
  person.stick(1.05, 0.0F, 1.0F);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  expect_neutral_first(person, 0.0F, 1.0F);
}

// Control is taken on the way to a goal: what was taken ends with it, and the next goal begins in AUTONOMY.
TEST(WithoutGoal, ControlThatWasTakenEndsWithTheGoal) {
  Person person(in_mode(OperatorMode::switching));
  person.stick(1.0, 0.0F);
  person.cycle(1.0);
  person.machine.take_control(true);
  EXPECT_EQ(person.cycle(1.05).state, State::manual);
  person.machine.set_goalless(true);
  EXPECT_FALSE(person.machine.manual());
  EXPECT_EQ(person.cycle(1.1).state, State::autonomy);
  person.machine.take_control(true);  // there is nothing to take
  EXPECT_EQ(person.cycle(1.15).state, State::autonomy);
  person.machine.set_goalless(false);
  EXPECT_FALSE(person.machine.manual());
  EXPECT_EQ(person.cycle(1.2).state, State::autonomy);
}

TEST(WithoutGoal, SilenceIsALossAndStops) {
  Person person(in_mode(OperatorMode::joystick));
  person.machine.set_goalless(true);
  person.steer(1.0, 0.0F, 1.0F);
  expect_intent(person.cycle(1.05 + person.p.input_timeout + 0.01), State::lost, Influence::stop, 0.0, 0.0);
  EXPECT_FALSE(person.machine.steers());
}

TEST(WithoutGoal, AStopOutranksTheStick) {
  Person person(in_mode(OperatorMode::joystick));
  person.machine.set_goalless(true);
  person.steer(1.0, 0.0F, 1.0F);
  person.machine.stop(true);
  expect_intent(person.cycle(1.1), State::stopped, Influence::stop, 0.0, 0.0);
}

// What was remembered before a cycle repeats it.
TEST(WithoutGoal, ItIsRemembered) {
  Person person(in_mode(OperatorMode::joystick)), other(in_mode(OperatorMode::joystick));
  person.machine.set_goalless(true);
  person.steer(1.0, 0.5F, 1.0F);
  Bytes state;
  ArchiveWriter write(state);
  person.machine.save(write);
  ArchiveReader read(state);
  other.machine.load(read);
  ASSERT_TRUE(read.complete());
  expect_intent(other.machine.update(1.1), State::manual, Influence::direct, 0.5, 0.25);  // 1, 0.5^2
  other.stick(1.15, 0.0F, 0.5F);
  expect_intent(other.machine.update(1.15), State::manual, Influence::direct, 0.125, 0.0);
}

}  // namespace
}  // namespace hidwa_local_planner::input
