// SPDX-License-Identifier: BSD-3-Clause
// While the host has no goal whoever steers drives, in every mode, with both axes of their device.
#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

/// Somebody whose host has no goal; linear is v_max.
struct Goalless : Person {
  explicit Goalless(const Parameters& parameters = Parameters()) : Person(parameters) { machine.set_goalless(true); }
};

TEST(WithoutGoal, BothAxesDriveInEveryModeOfTheStick) {
  for (const OperatorMode mode : {OperatorMode::joystick, OperatorMode::switching}) {
    Goalless person(in_mode(mode));
    expect_autonomy(person.cycle_with_stick(1.0, 0.0F));
    expect_manual(person.cycle_with_stick(1.05, 0.0F, 1.0F), 0.5, 0.0);
    EXPECT_TRUE(person.machine.steers());
    expect_manual(person.cycle_with_stick(1.1, -0.5F, 0.5F), 0.125, -0.25);  // 0.5^2 * 0.5, -(0.5^2) * 1
    expect_autonomy(person.cycle_with_stick(1.15, 0.0F, 0.0F));              // no HOLD
  }
}

TEST(WithoutGoal, AlwaysGuarded) {
  Parameters p = in_mode(OperatorMode::switching);
  p.guard = Guard::none;
  EXPECT_TRUE(Goalless(p).steer(1.0, 0.0F, 1.0F).guarded);
}

TEST(WithoutGoal, ModeOffDrivesNothing) {
  expect_autonomy(Goalless(in_mode(OperatorMode::off)).steer(1.0, 1.0F, 1.0F));
}

// With a goal the stick's side alone counts again; a stick that is held forward then asks for nothing.
TEST(WithoutGoal, AGoalComesWhileTheStickIsHeld) {
  Goalless person;
  person.steer(1.0, 0.0F, 1.0F);
  person.machine.set_goalless(false);
  EXPECT_EQ(person.cycle(1.1).state, State::autonomy);
  expect_shared(person.cycle_with_stick(1.15, 1.0F, 1.0F), 0.5, 1.0);
}

// The stick steers, or is held straight forward, which with a goal asks for nothing. It does not drive on when the goal
// ends.
TEST(WithoutGoal, AStickHeldWhenAGoalEndsMustBeNeutralFirst) {
  for (const float angular : {1.0F, 0.0F}) {
    Person person;
    EXPECT_EQ(person.steer(1.0, angular, 1.0F).state, angular > 0.0F ? State::shared : State::autonomy);
    person.machine.set_goalless(true);
    person.stick(1.1, angular, 1.0F);
    EXPECT_FALSE(person.machine.steers());
    expect_autonomy(person.cycle(1.1));
    EXPECT_EQ(person.steer(1.15, 0.0F, 1.0F).state, State::manual);
  }
}

// Control is taken on the way to a goal: what was taken ends with it, and the next goal begins in AUTONOMY.
TEST(WithoutGoal, ControlThatWasTakenEndsWithTheGoal) {
  Person person(in_mode(OperatorMode::switching));
  person.cycle_with_stick(1.0, 0.0F);
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
  Goalless person;
  person.steer(1.0, 0.0F, 1.0F);
  expect_lost(person.cycle(1.05 + person.p.input_timeout + 0.01), Influence::stop);
  EXPECT_FALSE(person.machine.steers());
}

TEST(WithoutGoal, AStopOutranksTheStick) {
  Goalless person;
  person.steer(1.0, 0.0F, 1.0F);
  person.machine.stop(true);
  expect_stopped(person.cycle(1.1));
}

// What was remembered before a cycle repeats it.
TEST(WithoutGoal, ItIsRemembered) {
  Goalless person;
  person.steer(1.0, 0.5F, 1.0F);
  Person other;
  load(other.machine, saved(person.machine));
  expect_manual(other.machine.update(1.1), 0.5, 0.25);  // 1, 0.5^2
  expect_manual(other.cycle_with_stick(1.15, 0.0F, 0.5F), 0.125, 0.0);
}

}  // namespace
}  // namespace hidwa_local_planner::input
