// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;
constexpr double kPeriod = 0.05;    // of the cycle and of the stick [s]
constexpr double kTimeout = 0.5;    // input_timeout [s]
constexpr double kDelta = 2.0;      // [s]
constexpr double kRounding = 1e-9;  // of the times below [s]

Parameters with_policy(OnInputLost policy) {
  Parameters p;
  p.on_input_lost = policy;
  return p;
}

/// Steers fully deflected until `cut`, then nothing arrives any more; says how long each command counted
/// after it.
struct Cut {
  double omega = 0.0;                 // [s]
  double v = 0.0;                     // [s]
  Influence after = Influence::none;  // 10 s later
  State state = State::autonomy;      // 10 s later
};

Cut cut_link(const Parameters& p, double phase) {
  Person person(p);
  person.stick(1.0, 0.0F);
  double cut = 0.0;
  for (int i = 1; i <= 20; ++i) {
    cut = 1.0 + kPeriod * i;
    person.stick(cut, 1.0F);
    EXPECT_EQ(person.cycle(cut + phase).state, State::shared);
  }
  Cut result;
  for (int i = 21; i <= 220; ++i) {
    const double now = 1.0 + kPeriod * i + phase;
    const OperatorIntent intent = person.cycle(now);
    const bool counts = intent.influence == Influence::shared;
    // A command counts until the next cycle replaces it.
    if (counts && intent.u_h.omega != 0.0) result.omega = now - cut + kPeriod;
    if (counts && intent.u_h.v != 0.0) result.v = now - cut + kPeriod;
    result.after = intent.influence;
    result.state = intent.state;
  }
  return result;
}

TEST(LostLink, TheTurnCountsAtMostTheTimeoutAndACycle) {
  for (const OnInputLost policy : {OnInputLost::hold, OnInputLost::stop, OnInputLost::autonomy}) {
    for (const double phase : {0.0, 0.001, 0.025, 0.049}) {
      const Cut cut = cut_link(with_policy(policy), phase);
      EXPECT_LE(cut.omega, kTimeout + kPeriod + kRounding);
      EXPECT_GT(cut.omega, kTimeout);  // and not less: the person may rely on it
      EXPECT_EQ(cut.state, State::lost);
    }
  }
}

TEST(LostLink, TheVelocityCountsNoLongerUnderStopAndAutonomy) {
  for (const OnInputLost policy : {OnInputLost::stop, OnInputLost::autonomy}) {
    const Cut cut = cut_link(with_policy(policy), 0.02);
    EXPECT_LE(cut.v, kTimeout + kPeriod + kRounding);
    EXPECT_EQ(cut.after, policy == OnInputLost::stop ? Influence::stop : Influence::none);
  }
}

TEST(LostLink, TheVelocityCountsDeltaUnderHold) {
  const Cut cut = cut_link(with_policy(OnInputLost::hold), 0.02);
  EXPECT_LE(cut.v, kDelta + kPeriod + kRounding);  // from the last active input, so less than delta longer
  EXPECT_GT(cut.v, kDelta - kPeriod);
  EXPECT_EQ(cut.after, Influence::none);
}

TEST(LostLink, ATimeoutLongerThanDeltaLeavesNothingToHold) {
  Parameters p;
  p.delta = 0.2;
  const Cut cut = cut_link(p, 0.02);
  EXPECT_LE(cut.v, kTimeout + kPeriod + kRounding);
}

TEST(LostLink, LostIsToldAtOnce) {
  Person person;
  person.steer(1.0);                                   // active at 1.05
  EXPECT_EQ(person.cycle(1.54).state, State::shared);  // 0.49 s
  expect_intent(person.cycle(1.56), State::lost, Influence::shared, 0.5, 0.0);
}

TEST(LostLink, AHoldAfterALossEndsWhenItIsRejected) {
  Person person;
  person.steer(1.0);
  CycleFeedback rejected;
  rejected.operator_command_rejected = true;
  expect_intent(person.cycle(1.6, rejected), State::lost, Influence::shared, 0.5, 0.0);
  expect_intent(person.cycle(1.65), State::lost, Influence::none, 0.0, 0.0);
}

TEST(LostLink, ReturnsOnlyAfterTheStickWasSeenCentred) {
  Person person;
  person.steer(1.0);
  EXPECT_EQ(person.cycle(1.6).state, State::lost);
  for (double time = 5.0; time < 6.0; time += kPeriod) {
    person.stick(time, 1.0F);
    expect_intent(person.cycle(time), State::lost, Influence::none, 0.0, 0.0);
  }
  EXPECT_NE(person.machine.advice().find("require_neutral"), std::string::npos);
  person.stick(6.0, 0.0F);
  EXPECT_EQ(person.cycle(6.0).state, State::autonomy);  // 6.0 - 1.05 > delta
  person.stick(6.05, 1.0F);
  EXPECT_EQ(person.cycle(6.05).state, State::shared);
}

TEST(LostLink, ReturnsAtOnceWhereNeutralIsNotRequired) {
  Parameters p;
  p.require_neutral = false;
  Person person(p);
  person.steer(1.0);
  EXPECT_EQ(person.cycle(1.6).state, State::lost);
  person.stick(1.7, 1.0F);
  EXPECT_EQ(person.cycle(1.7).state, State::shared);
}

TEST(LostLink, ACentredStickThatReturnsIsTheReleaseThatWasAssumed) {
  Person person;
  person.steer(1.0);
  EXPECT_EQ(person.cycle(1.6).state, State::lost);
  person.stick(1.7, 0.0F);
  expect_intent(person.cycle(1.7), State::hold, Influence::shared, 0.5, 0.0);
  EXPECT_EQ(person.cycle(3.04).state, State::hold);  // still 2 s from 1.05
  EXPECT_EQ(person.cycle(3.06).state, State::autonomy);
}

TEST(LostLink, ACentredStickThatReturnsEndsTheStop) {
  for (const OnInputLost policy : {OnInputLost::stop, OnInputLost::autonomy}) {
    Person person(with_policy(policy));
    person.steer(1.0);
    EXPECT_EQ(person.cycle(1.6).state, State::lost);
    person.stick(1.7, 0.0F);
    expect_intent(person.cycle(1.7), State::autonomy, Influence::none, 0.0, 0.0);
  }
}

TEST(LostLink, AStopStaysAtTheGoal) {
  Person person(with_policy(OnInputLost::stop));
  person.steer(1.0);
  CycleFeedback latched;
  latched.goal_latched = true;
  EXPECT_EQ(person.cycle(1.6, latched).influence, Influence::stop);
  EXPECT_EQ(person.cycle(1.65, latched).influence, Influence::stop);
}

TEST(LostLink, AHoldDoesNotStayAtTheGoal) {
  Person person;
  person.steer(1.0);
  CycleFeedback latched;
  latched.goal_latched = true;
  EXPECT_EQ(person.cycle(1.6, latched).influence, Influence::shared);
  expect_intent(person.cycle(1.65, latched), State::lost, Influence::none, 0.0, 0.0);
}

TEST(LostLink, SilenceDuringHoldIsNoLoss) {
  Person person;
  person.steer(1.0);
  person.stick(1.1, 0.0F);
  EXPECT_EQ(person.cycle(1.1).state, State::hold);
  EXPECT_EQ(person.cycle(2.9).state, State::hold);
  EXPECT_EQ(person.cycle(3.1).state, State::autonomy);
}

TEST(LostLink, InputThatWasNeverInEffectIsNotLost) {
  Person person(with_policy(OnInputLost::stop));
  person.stick(1.0, 0.0F);
  person.stick(1.05, 1.0F);
  expect_intent(person.cycle(60.0), State::autonomy, Influence::none, 0.0,
                0.0);  // the first goal a minute later
  person.stick(60.05, 1.0F);
  EXPECT_EQ(person.cycle(60.05).state, State::autonomy);  // it fell silent: to be seen centred first
}

TEST(LostLink, LostFromBlocked) {
  Parameters p;
  p.blocked_time = 0.0;
  Person person(p);
  CycleFeedback rejected;
  rejected.operator_command_rejected = true;
  rejected.stands = true;
  person.stick(1.0, 0.0F);
  person.stick(1.05, 1.0F);
  person.cycle(1.05, rejected);
  EXPECT_EQ(person.cycle(1.1, rejected).state, State::blocked);
  EXPECT_EQ(person.cycle(1.6).state, State::lost);
}

}  // namespace
}  // namespace hidwa_local_planner::input
