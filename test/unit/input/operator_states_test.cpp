// SPDX-License-Identifier: BSD-3-Clause
// What the states depend on besides the stories of twin_test.cpp.
#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

// The control loop may fail before it can say what became of a cycle.
TEST(OperatorStates, AReleaseMeasuresTheBlockageAnewWithoutADebriefToo) {
  Person person;
  person.steer(1.0, 1.0F, 0.0F, rejected_at_rest());
  person.stick(1.1, 0.0F);
  EXPECT_EQ(person.machine.update(1.1).state, State::hold);
  person.stick(2.5, 1.0F);
  EXPECT_EQ(person.machine.update(2.5).state, State::shared);
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
