// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;

CycleFeedback rejected_at_rest() {
  CycleFeedback feedback;
  feedback.operator_command_rejected = true;
  feedback.stands = true;
  return feedback;
}

CycleFeedback at_goal() {
  CycleFeedback feedback;
  feedback.goal_latched = true;
  return feedback;
}

TEST(OperatorStates, AutonomyWithoutInput) {
  Person person;
  expect_intent(person.cycle(1.0), State::autonomy, Influence::none, 0.0, 0.0);
  EXPECT_LT(person.machine.input_age(1.0), 0.0);
  person.stick(1.0, 0.0F);
  expect_intent(person.cycle(1.05), State::autonomy, Influence::none, 0.0, 0.0);
  expect_intent(person.cycle(100.0), State::autonomy, Influence::none, 0.0,
                0.0);  // a centred stick may be silent
  EXPECT_DOUBLE_EQ(person.machine.input_age(100.0), 99.0);
}

TEST(OperatorStates, SharedInTheNextCycle) {
  Person person;
  person.stick(1.0, 0.0F);
  person.stick(1.02, -0.5F);
  expect_intent(person.cycle(1.05), State::shared, Influence::shared, 0.5, -0.25);  // v_max, -(0.5^2)
  person.stick(1.07, 1.0F);
  expect_intent(person.cycle(1.1), State::shared, Influence::shared, 0.5, 1.0);
}

TEST(OperatorStates, HoldRunsDeltaFromTheLastActiveInput) {
  Person person;      // delta 2 s
  person.steer(1.0);  // last active input: 1.05
  person.stick(1.1, 0.0F);
  expect_intent(person.cycle(1.1), State::hold, Influence::shared, 0.5, 0.0);
  expect_intent(person.cycle(3.04), State::hold, Influence::shared, 0.5, 0.0);    // 3.04 - 1.05 = 1.99 < 2
  expect_intent(person.cycle(3.06), State::autonomy, Influence::none, 0.0, 0.0);  // 2.01
}

TEST(OperatorStates, HoldIsInTimeNotInCycles) {
  Person person;
  person.steer(1.0);
  person.stick(1.1, 0.0F);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(person.cycle(1.1 + 1e-3 * i).state, State::hold);
  EXPECT_EQ(person.cycle(3.06).state, State::autonomy);
}

TEST(OperatorStates, NoHoldWithoutDelta) {
  Parameters p;
  p.delta = 0.0;
  Person person(p);
  person.steer(1.0);
  person.stick(1.1, 0.0F);
  EXPECT_EQ(person.cycle(1.1).state, State::autonomy);
}

TEST(OperatorStates, HoldKeepsThePersonsVelocityAtRelease) {
  Parameters p;
  p.linear = LinearPolicy::axis;
  Person person(p);
  person.steer(1.0, 1.0F, 1.0F);
  person.stick(1.1, 1.0F, 0.8F);
  person.stick(1.12, 0.0F);
  const double p_y = static_cast<double>(0.8F);
  expect_intent(person.cycle(1.15), State::hold, Influence::shared, p_y * p_y * 0.5, 0.0);  // 0.32 m/s
}

TEST(OperatorStates, TheRobotsOwnSpeedWhereThatIsThePolicy) {
  Parameters p;
  p.linear = LinearPolicy::current;
  Person person(p);
  person.stick(1.0, 0.0F);
  person.stick(1.05, 0.5F);
  CycleFeedback feedback;
  feedback.command = {0.2, 0.1};
  expect_intent(person.cycle(1.05, feedback), State::shared, Influence::shared, 0.0, 0.25);  // no command yet
  expect_intent(person.cycle(1.1, feedback), State::shared, Influence::shared, 0.2, 0.25);
  feedback.command = {0.35, 0.2};
  expect_intent(person.cycle(1.15, feedback), State::shared, Influence::shared, 0.2, 0.25);  // the last one's
  person.stick(1.2, 0.0F);
  feedback.command = {0.1, 0.0};
  expect_intent(person.cycle(1.2, feedback), State::hold, Influence::shared, 0.35, 0.0);
  expect_intent(person.cycle(1.25, feedback), State::hold, Influence::shared, 0.35, 0.0);  // as it was then
}

TEST(OperatorStates, HoldEndsWhenItIsRejected) {
  Person person;
  person.steer(1.0);
  person.stick(1.1, 0.0F);
  CycleFeedback rejected;
  rejected.operator_command_rejected = true;
  EXPECT_EQ(person.cycle(1.1, rejected).state, State::hold);
  EXPECT_EQ(person.machine.state(), State::hold);  // that cycle was a hold
  EXPECT_EQ(person.cycle(1.15).state, State::autonomy);
  EXPECT_EQ(person.cycle(1.2).state, State::autonomy);
}

TEST(OperatorStates, HoldStaysWhenRejectedWhereThePaperSaysSo) {
  Parameters p;
  p.method = Method::paper;
  Person person(p);
  person.steer(1.0);
  person.stick(1.1, 0.0F);
  CycleFeedback rejected;
  rejected.operator_command_rejected = true;
  person.cycle(1.1, rejected);
  EXPECT_EQ(person.cycle(1.15).state, State::hold);
}

TEST(OperatorStates, ARejectionWhileSteeringDoesNotEndTheHoldAfterIt) {
  Person person;
  person.stick(1.0, 0.0F);
  person.stick(1.05, 1.0F);
  CycleFeedback rejected;
  rejected.operator_command_rejected = true;
  EXPECT_EQ(person.cycle(1.05, rejected).state, State::shared);
  person.stick(1.1, 0.0F);
  EXPECT_EQ(person.cycle(1.1).state, State::hold);
}

TEST(OperatorStates, InputDuringHoldIsSharedAtOnceAndHoldsAfresh) {
  Person person;
  person.steer(1.0);
  person.stick(1.1, 0.0F);
  EXPECT_EQ(person.cycle(1.1).state, State::hold);
  person.stick(2.0, -1.0F);
  expect_intent(person.cycle(2.0), State::shared, Influence::shared, 0.5, -1.0);
  person.stick(2.05, 0.0F);
  EXPECT_EQ(person.cycle(2.05).state, State::hold);
  EXPECT_EQ(person.cycle(3.99).state, State::hold);  // 3.99 - 2.0 < 2
  EXPECT_EQ(person.cycle(4.01).state, State::autonomy);
}

TEST(OperatorStates, WhatNoCycleHasSeenCannotBeReleased) {
  Person person;
  person.stick(1.0, 0.0F);
  person.cycle(1.0);
  person.stick(1.01, 1.0F);
  person.stick(1.02, 0.0F);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
}

TEST(OperatorStates, BlockedAndFreed) {
  Person person;      // blocked_time 1 s
  person.steer(1.0);  // a cycle at 1.05
  double time = 1.1;
  for (; time < 2.08; time += 0.05) {  // held from 1.10 on
    person.stick(time, 1.0F);
    EXPECT_EQ(person.cycle(time, rejected_at_rest()).state, State::shared) << time;
  }
  person.stick(2.11, 1.0F);
  expect_intent(person.cycle(2.11, rejected_at_rest()), State::blocked, Influence::shared, 0.5, 1.0);
  person.stick(2.2, -1.0F);
  expect_intent(person.cycle(2.2, rejected_at_rest()), State::blocked, Influence::shared, 0.5, -1.0);
  person.stick(2.25, -1.0F);
  EXPECT_EQ(person.cycle(2.25, CycleFeedback()).state, State::blocked);  // it moves in this cycle
  person.stick(2.3, -1.0F);
  EXPECT_EQ(person.cycle(2.3).state, State::shared);
}

TEST(OperatorStates, AMomentOfMotionMeasuresTheBlockageAnew) {
  Person person;
  person.steer(1.0);
  for (int i = 1; i < 100; ++i) {
    const double time = 1.05 + 0.05 * i;
    person.stick(time, 1.0F);
    const bool moves = i % 15 == 0;  // every 0.75 s < blocked_time
    EXPECT_EQ(person.cycle(time, moves ? CycleFeedback() : rejected_at_rest()).state, State::shared) << time;
  }
}

// The control loop may fail before it can say what became of a cycle.
TEST(OperatorStates, AReleaseMeasuresTheBlockageAnewWithoutADebriefToo) {
  Person person;
  person.stick(1.0, 0.0F);
  person.stick(1.05, 1.0F);
  person.cycle(1.05, rejected_at_rest());
  person.stick(1.1, 0.0F);
  EXPECT_EQ(person.machine.update(1.1).state, State::hold);
  person.stick(2.5, 1.0F);
  EXPECT_EQ(person.machine.update(2.5).state, State::shared);
}

TEST(OperatorStates, ReleaseFromBlockedIsARelease) {
  Parameters p;
  p.blocked_time = 0.0;
  Person person(p);
  person.stick(1.0, 0.0F);
  person.stick(1.05, 1.0F);
  person.cycle(1.05, rejected_at_rest());
  EXPECT_EQ(person.cycle(1.1, rejected_at_rest()).state, State::blocked);
  person.stick(1.15, 0.0F);
  EXPECT_EQ(person.cycle(1.15).state, State::hold);
}

TEST(OperatorStates, AtRestByItselfIsNotBlocked) {
  Parameters p;
  p.blocked_time = 0.0;
  Person person(p);
  person.steer(1.0);
  CycleFeedback rest;
  rest.stands = true;
  person.cycle(1.1, rest);
  EXPECT_EQ(person.cycle(1.15, rest).state, State::shared);
}

TEST(OperatorStates, GoalLatchEndsSteering) {
  Person person;
  person.stick(1.0, 0.0F);
  person.stick(1.05, 1.0F);
  EXPECT_EQ(person.cycle(1.05, at_goal()).state, State::shared);  // latched in this cycle
  person.stick(1.1, 1.0F);
  expect_intent(person.cycle(1.1, at_goal()), State::autonomy, Influence::none, 0.0, 0.0);
  EXPECT_EQ(person.cycle(2.0, at_goal()).state, State::autonomy);  // silent: there is nothing to lose
}

TEST(OperatorStates, GoalLatchEndsAHoldForGood) {
  Person person;
  person.steer(1.0);
  person.stick(1.1, 0.0F);
  EXPECT_EQ(person.cycle(1.1, at_goal()).state, State::hold);
  EXPECT_EQ(person.cycle(1.15, at_goal()).state, State::autonomy);
  person.machine.new_goal();
  EXPECT_EQ(person.cycle(1.2).state, State::autonomy);
}

TEST(OperatorStates, SteeringInTheGoalWindowWhereThePaperSaysSo) {
  Parameters p;
  p.method = Method::paper;
  Person person(p);
  person.stick(1.0, 0.0F);
  person.stick(1.05, 1.0F);
  person.cycle(1.05, at_goal());
  EXPECT_EQ(person.cycle(1.1, at_goal()).state, State::shared);
}

TEST(OperatorStates, ANewGoalLeavesTheStickAlone) {
  Person person;
  person.steer(1.0);
  person.machine.new_goal();
  expect_intent(person.cycle(1.1), State::shared, Influence::shared, 0.5, 1.0);
  person.stick(1.15, 0.0F);
  EXPECT_EQ(person.cycle(1.15).state, State::hold);
  person.machine.new_goal();
  EXPECT_EQ(person.cycle(1.2).state, State::hold);
}

TEST(OperatorStates, ANewGoalAfterALatchGivesTheStickBack) {
  Person person;
  person.stick(1.0, 0.0F);
  person.stick(1.05, 1.0F);
  person.cycle(1.05, at_goal());
  EXPECT_EQ(person.cycle(1.1, at_goal()).state, State::autonomy);
  person.stick(1.12, 1.0F);
  person.machine.new_goal();
  EXPECT_EQ(person.cycle(1.15).state, State::shared);
}

TEST(OperatorStates, StartWithADeflectedStick) {
  Person person;
  for (double time = 1.0; time < 2.0; time += 0.05) {
    person.stick(time, 1.0F);
    EXPECT_EQ(person.cycle(time).state, State::autonomy);
  }
  EXPECT_NE(person.machine.advice().find("require_neutral"), std::string::npos);
  person.stick(2.0, 0.0F);
  EXPECT_EQ(person.cycle(2.0).state, State::autonomy);
  EXPECT_EQ(person.machine.advice(), "");
  person.stick(2.05, 1.0F);
  EXPECT_EQ(person.cycle(2.05).state, State::shared);
}

TEST(OperatorStates, StartWithADeflectedStickWhereThatIsAllowed) {
  Parameters p;
  p.require_neutral = false;
  Person person(p);
  person.stick(1.0, 1.0F);
  EXPECT_EQ(person.cycle(1.0).state, State::shared);
}

TEST(OperatorStates, EnableButton) {
  Parameters p;
  p.enable_button = 1;
  Person person(p);
  StickMessage message = stick_at(1.0, 1.0F);
  person.machine.receive(message);
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);  // deflected, not enabled
  message = stick_at(1.05, 0.0F);
  message.buttons = {0, 1};
  person.machine.receive(message);
  expect_intent(person.cycle(1.05), State::shared, Influence::shared, 0.5, 0.0);
  person.machine.receive(stick_at(1.1, 1.0F));  // button released, stick still deflected: a release
  expect_intent(person.cycle(1.1), State::hold, Influence::shared, 0.5, 0.0);
}

TEST(OperatorStates, EnableButtonHeldAtTheStart) {
  Parameters p;
  p.enable_button = 1;
  Person person(p);
  StickMessage message = stick_at(1.0, 0.0F);
  message.buttons = {0, 1};
  person.machine.receive(message);
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
}

}  // namespace
}  // namespace hidwa_local_planner::input
