// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

TEST(OperatorStates, AutonomyWithoutInput) {
  Person person;
  expect_autonomy(person.cycle(1.0));
  EXPECT_LT(person.machine.input_age(1.0), 0.0);
  person.stick(1.0, 0.0F);
  expect_autonomy(person.cycle(1.05));
  expect_autonomy(person.cycle(100.0));  // a centred stick may be silent
  EXPECT_DOUBLE_EQ(person.machine.input_age(100.0), 99.0);
}

TEST(OperatorStates, SharedInTheNextCycle) {
  Person person;
  person.stick(1.0, 0.0F);
  person.stick(1.02, -0.5F);
  expect_shared(person.cycle(1.05), 0.5, -0.25);  // v_max, -(0.5^2)
  person.stick(1.07, 1.0F);
  expect_shared(person.cycle(1.1), 0.5, 1.0);
}

TEST(OperatorStates, HoldRunsDeltaFromTheLastActiveInput) {
  Person person;      // delta 2 s
  person.steer(1.0);  // last active input: 1.05
  expect_hold(person.cycle_with_stick(1.1, 0.0F), 0.5);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(person.cycle(1.1 + 1e-3 * i).state, State::hold);  // in time, not in cycles
  expect_hold(person.cycle(3.04), 0.5);                                                       // 3.04 - 1.05 = 1.99 < 2
  expect_autonomy(person.cycle(3.06));                                                        // 2.01
}

TEST(OperatorStates, HoldKeepsThePersonsVelocityAtRelease) {
  Parameters p;
  p.linear = LinearPolicy::axis;
  Person person(p);
  person.steer(1.0, 1.0F, 1.0F);
  person.stick(1.1, 1.0F, 0.8F);
  person.stick(1.12, 0.0F);
  const double p_y = static_cast<double>(0.8F);
  expect_hold(person.cycle(1.15), p_y * p_y * 0.5);  // 0.32 m/s
}

TEST(OperatorStates, TheRobotsOwnSpeedWhereThatIsThePolicy) {
  Parameters p;
  p.linear = LinearPolicy::current;
  Person person(p);
  CycleFeedback feedback;
  feedback.command = {0.2, 0.1};
  expect_shared(person.steer(1.0, 0.5F, 0.0F, feedback), 0.0, 0.25);  // no command yet
  expect_shared(person.cycle(1.1, feedback), 0.2, 0.25);
  feedback.command = {0.35, 0.2};
  expect_shared(person.cycle(1.15, feedback), 0.2, 0.25);  // the last one's
  feedback.command = {0.1, 0.0};
  expect_hold(person.cycle_with(stick_at(1.2, 0.0F), feedback), 0.35);
  expect_hold(person.cycle(1.25, feedback), 0.35);  // as it was then
}

TEST(OperatorStates, HoldEndsWhenItIsRejected) {
  Person person;
  person.steer(1.0);
  EXPECT_EQ(person.cycle_with(stick_at(1.1, 0.0F), rejected()).state, State::hold);
  EXPECT_EQ(person.machine.state(), State::hold);  // that cycle was a hold
  EXPECT_EQ(person.cycle(1.15).state, State::autonomy);
  EXPECT_EQ(person.cycle(1.2).state, State::autonomy);
}

TEST(OperatorStates, InputDuringHoldIsSharedAtOnceAndHoldsAfresh) {
  Person person;
  person.steer(1.0);
  EXPECT_EQ(person.cycle_with_stick(1.1, 0.0F).state, State::hold);
  expect_shared(person.cycle_with_stick(2.0, -1.0F), 0.5, -1.0);
  EXPECT_EQ(person.cycle_with_stick(2.05, 0.0F).state, State::hold);
  EXPECT_EQ(person.cycle(3.99).state, State::hold);  // 3.99 - 2.0 < 2
  EXPECT_EQ(person.cycle(4.01).state, State::autonomy);
}

TEST(OperatorStates, BlockedAndFreed) {
  Person person;      // blocked_time 1 s
  person.steer(1.0);  // a cycle at 1.05
  const auto held = [&person](double time, float angular) {
    return person.cycle_with(stick_at(time, angular), rejected_at_rest());
  };
  for (double time = 1.1; time < 2.08; time += 0.05) EXPECT_EQ(held(time, 1.0F).state, State::shared) << time;
  expect_intent(held(2.11, 1.0F), State::blocked, Influence::shared, 0.5, 1.0);
  expect_intent(held(2.2, -1.0F), State::blocked, Influence::shared, 0.5, -1.0);
  EXPECT_EQ(person.cycle_with_stick(2.25, -1.0F).state, State::blocked);  // it moves in this cycle
  EXPECT_EQ(person.cycle_with_stick(2.3, -1.0F).state, State::shared);
}

// The control loop may fail before it can say what became of a cycle.
TEST(OperatorStates, AReleaseMeasuresTheBlockageAnewWithoutADebriefToo) {
  Person person;
  person.steer(1.0, 1.0F, 0.0F, rejected_at_rest());
  person.stick(1.1, 0.0F);
  EXPECT_EQ(person.machine.update(1.1).state, State::hold);
  person.stick(2.5, 1.0F);
  EXPECT_EQ(person.machine.update(2.5).state, State::shared);
}

TEST(OperatorStates, GoalLatchEndsSteering) {
  Person person;
  EXPECT_EQ(person.steer(1.0, 1.0F, 0.0F, at_goal()).state, State::shared);  // latched in this cycle
  expect_autonomy(person.cycle_with(stick_at(1.1, 1.0F), at_goal()));
  EXPECT_EQ(person.cycle(2.0, at_goal()).state, State::autonomy);  // silent: there is nothing to lose
}

TEST(OperatorStates, ANewGoalAfterALatchGivesTheStickBack) {
  Person person;
  person.steer(1.0, 1.0F, 0.0F, at_goal());
  EXPECT_EQ(person.cycle(1.1, at_goal()).state, State::autonomy);
  person.stick(1.12, 1.0F);
  person.machine.new_goal();
  EXPECT_EQ(person.cycle(1.15).state, State::shared);
}

TEST(OperatorStates, StartWithADeflectedStick) {
  Person person;
  for (double time = 1.0; time < 2.0; time += 0.05) {
    EXPECT_EQ(person.cycle_with_stick(time, 1.0F).state, State::autonomy);
  }
  EXPECT_TRUE(says(person.machine.advice(), "require_neutral"));
  EXPECT_EQ(person.cycle_with_stick(2.0, 0.0F).state, State::autonomy);
  EXPECT_EQ(person.machine.advice(), "");
  EXPECT_EQ(person.cycle_with_stick(2.05, 1.0F).state, State::shared);
}

TEST(OperatorStates, StartWithADeflectedStickWhereThatIsAllowed) {
  Parameters p;
  p.require_neutral = false;
  Person person(p);
  EXPECT_EQ(person.cycle_with_stick(1.0, 1.0F).state, State::shared);
}

TEST(OperatorStates, EnableButton) {
  Parameters p;
  p.enable_button = 1;
  EXPECT_EQ(Person(p).cycle_with_button(1.0, 1).state, State::autonomy);  // held at the start
  Person person(p);
  EXPECT_EQ(person.cycle_with_stick(1.0, 1.0F).state, State::autonomy);  // deflected, not enabled
  expect_shared(person.cycle_with_button(1.05, 1), 0.5, 0.0);
  expect_hold(person.cycle_with_stick(1.1, 1.0F), 0.5);  // button released, stick still deflected: a release
}

}  // namespace
}  // namespace hidwa_local_planner::input
