// SPDX-License-Identifier: BSD-3-Clause
// A stick whose link is lost and comes back. For how long it counts after a cut: cut_link_test.cpp.
#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

TEST(LostLink, LostIsToldAtOnce) {
  Person person;
  person.steer(1.0);                                   // active at 1.05
  EXPECT_EQ(person.cycle(1.54).state, State::shared);  // 0.49 s
  expect_intent(person.cycle(1.56), State::lost, Influence::shared, 0.5, 0.0);
}

TEST(LostLink, ReturnsOnlyAfterTheStickWasSeenCentred) {
  Person person;
  person.steer(1.0);
  EXPECT_EQ(person.cycle(1.6).state, State::lost);
  for (double time = 5.0; time < 6.0; time += 0.05) expect_lost(person.cycle_with_stick(time, 1.0F), Influence::none);
  EXPECT_TRUE(says(person.machine.advice(), "require_neutral"));
  EXPECT_EQ(person.cycle_with_stick(6.0, 0.0F).state, State::autonomy);  // 6.0 - 1.05 > delta
  EXPECT_EQ(person.cycle_with_stick(6.05, 1.0F).state, State::shared);
}

TEST(LostLink, ACentredStickThatReturnsIsTheReleaseThatWasAssumed) {
  Person person;
  person.steer(1.0);
  EXPECT_EQ(person.cycle(1.6).state, State::lost);
  expect_hold(person.cycle_with_stick(1.7, 0.0F), 0.5);
  EXPECT_EQ(person.cycle(3.04).state, State::hold);  // still 2 s from 1.05
  EXPECT_EQ(person.cycle(3.06).state, State::autonomy);
}

TEST(LostLink, ACentredStickThatReturnsEndsTheStop) {
  for (const OnInputLost policy : {OnInputLost::stop, OnInputLost::autonomy}) {
    Person person(with_policy(policy));
    person.steer(1.0);
    EXPECT_EQ(person.cycle(1.6).state, State::lost);
    expect_autonomy(person.cycle_with_stick(1.7, 0.0F));
  }
}

TEST(LostLink, InputThatWasNeverInEffectIsNotLost) {
  Person person(with_policy(OnInputLost::stop));
  person.stick(1.0, 0.0F);
  person.stick(1.05, 1.0F);
  expect_autonomy(person.cycle(60.0));                                     // the first goal a minute later
  EXPECT_EQ(person.cycle_with_stick(60.05, 1.0F).state, State::autonomy);  // it fell silent: to be seen centred first
}

// No cycle ran during the gap (no goal was active): the gap is a loss all the same.
TEST(LostLink, AGapWithoutCyclesIsALossToo) {
  Person person;
  person.steer(1.0);
  EXPECT_EQ(person.cycle_with_stick(4.0, 1.0F).state, State::lost);
}

}  // namespace
}  // namespace hidwa_local_planner::input
