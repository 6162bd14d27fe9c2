// SPDX-License-Identifier: BSD-3-Clause
// A speed axis that does not rest at 0: a trigger, a pedal, a lever. Its driver sends 0 until it is touched.
#include <string>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;

Parameters by_axis(double rest, int sign) {
  Parameters p;  // max_vel_x 0.5, exponent 2
  p.linear = LinearPolicy::axis;
  p.axis_linear_rest = rest;
  p.axis_linear.reversed = sign < 0;
  return p;
}

// Released at 1, pressed to -1: full speed is 0.5 m/s, half pressed (0.5)^2 x 0.5 m/s.
TEST(Trigger, WithItsRestItGivesTheSpeedFromItsRest) {
  for (const double rest : {1.0, -1.0}) {
    const auto end = static_cast<float>(rest);
    Person person(by_axis(rest, rest > 0.0 ? -1 : 1));
    person.stick(1.0, 0.0F, 0.0F);  // not touched yet
    EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
    person.stick(1.05, 0.0F, end);
    EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
    person.stick(1.1, 0.0F, -end);
    expect_intent(person.cycle(1.1), State::shared, Influence::shared, 0.5, 0.0);
    person.stick(1.15, 0.0F, 0.0F);  // half pressed: it has moved, so that 0 is 0 now
    expect_intent(person.cycle(1.15), State::shared, Influence::shared, 0.125, 0.0);
    person.stick(1.2, 0.0F, end);
    EXPECT_EQ(person.cycle(1.2).state, State::hold);
    EXPECT_EQ(person.machine.advice(), "");
  }
}

// The rest of a worn stick, 0.15: the way to 1 is 0.85, and 1.15 is as far to the other side. 0.15 + 1.15 x 0.5 =
// 0.725.
TEST(Trigger, AnyRestCanBeGiven) {
  Person person(by_axis(0.15, 1));
  person.stick(1.0, 0.0F, 0.15F);
  person.stick(1.05, 0.0F, 0.725F);
  EXPECT_NEAR(person.cycle(1.05).u_h.v, 0.125, 1e-6);
  person.stick(1.1, 0.0F, 0.15F);
  EXPECT_EQ(person.cycle(1.1).state, State::hold);
}

/// A device with six axes, whose speed axis is one that no stick has.
StickMessage pad_at(double time, float angular, float trigger) {
  StickMessage message = stick_at(time, angular);
  message.axes = {angular, 0.0F, 0.0F, 0.0F, 0.0F, trigger};
  return message;
}

Parameters by_trigger() {
  Parameters p = by_axis(0.0, 1);
  p.axis_linear = {5};
  return p;
}

// What is not told of: its rest would be full speed ahead. It is asked for a centre that lasts, however it passes that.
TEST(Trigger, WithoutItsRestItIsAskedForItsCentre) {
  Person person(by_trigger());
  for (int i = 0; i < 20; ++i) person.machine.receive(pad_at(1.0 + 0.05 * i, 0.0F, 0.0F));
  for (int i = 0; i < 100; ++i) {
    const double time = 2.0 + 0.05 * i;
    person.machine.receive(pad_at(time, 0.0F, 1.0F));
    ASSERT_EQ(person.cycle(time).state, State::autonomy) << time;
  }
  EXPECT_NE(person.machine.advice().find("axes[5] led to its end 1"), std::string::npos) << person.machine.advice();
  EXPECT_NE(person.machine.advice().find("axis_linear_rest to 1"), std::string::npos);
  float value = 1.0F;  // pressed and let go, through its centre; beyond -0.8 it would be a pull
  for (int i = 0; i <= 34; ++i, value -= i < 17 ? 0.1F : -0.1F) {
    person.machine.receive(pad_at(7.0 + 0.05 * i, 0.0F, value));
    ASSERT_EQ(person.cycle(7.0 + 0.05 * i).state, State::autonomy) << value;
  }
  person.machine.receive(pad_at(9.1, 1.0F, 1.0F));  // the other axis steers, at rest
  expect_intent(person.cycle(9.1), State::shared, Influence::shared, 0.0, 1.0);
}

// A key or a cross of keys: from its second pressure on it counts, once it was let go for a second.
TEST(Trigger, WhatStandsInItsCentreForASecondIsNone) {
  Person person(by_trigger());
  person.machine.receive(pad_at(1.0, 0.0F, 0.0F));
  person.machine.receive(pad_at(1.05, 0.0F, 1.0F));
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  person.machine.receive(pad_at(1.1, 0.0F, 0.1F));   // within dead_zone
  person.machine.receive(pad_at(2.05, 0.0F, 1.0F));  // 0.95 s later
  EXPECT_EQ(person.cycle(2.05).state, State::autonomy);
  person.machine.receive(pad_at(3.0, 0.0F, 0.0F));
  person.machine.receive(pad_at(4.0, 0.0F, 1.0F));
  expect_intent(person.cycle(4.0), State::shared, Influence::shared, 0.5, 0.0);
  EXPECT_EQ(person.machine.advice(), "");
}

TEST(Trigger, WhatMovesOnItsWayIsNone) {
  Person person(by_trigger());
  person.machine.receive(pad_at(1.0, 0.0F, 0.0F));
  person.machine.receive(pad_at(1.05, 0.0F, 0.98F));
  EXPECT_EQ(person.cycle(1.05).state, State::shared);
}

// The first two axes are a stick wherever there is one: pushed to its end at once, as by a key, it drives on.
TEST(Trigger, AStickIsNeverAsked) {
  Person person(by_axis(0.0, 1));
  person.stick(1.0, 0.0F, 0.0F);
  for (int i = 1; i < 200; ++i) {
    person.stick(1.0 + 0.05 * i, 0.0F, 1.0F);
    ASSERT_EQ(person.cycle(1.0 + 0.05 * i).state, State::shared);
  }
}

// With the other sign it is a pull that never ends. A stop always counts; what it comes from is told, and it ends with
// the right mapping.
TEST(Trigger, AStopByItsRestIsNamedAndEndsWithTheMapping) {
  Parameters p;
  p.axis_linear = {5};
  p.axis_linear.reversed = true;
  Person person(p);
  person.machine.receive(pad_at(1.0, 0.0F, 0.0F));
  person.machine.receive(pad_at(1.05, 0.0F, 1.0F));
  EXPECT_EQ(person.cycle(1.05).state, State::stopped);
  EXPECT_NE(person.machine.advice().find("axis_linear_rest to 1"), std::string::npos);
  person.p.axis_linear_rest = 1.0;
  person.machine.configure(person.p);
  person.machine.receive(pad_at(1.1, 0.0F, 1.0F));
  EXPECT_EQ(person.cycle(1.1).state, State::autonomy);
  EXPECT_EQ(person.machine.advice(), "");
}

// In mode switching, too: whoever has control does not drive off.
TEST(Trigger, MovesNobodyWhoHasControl) {
  Parameters p;
  p.mode = OperatorMode::switching;
  p.axis_linear = {5};
  Person person(p);
  person.machine.receive(pad_at(1.0, 0.0F, 0.0F));
  person.cycle(1.0);
  person.machine.take_control(true);
  person.machine.receive(pad_at(1.05, 0.0F, 1.0F));
  expect_intent(person.cycle(1.05), State::manual, Influence::direct, 0.0, 0.0);
  person.machine.receive(pad_at(1.1, 0.5F, 1.0F));
  expect_intent(person.cycle(1.1), State::manual, Influence::direct, 0.0, 0.25);  // (0.5)^2 x 1 rad/s
}

// Another device begins anew.
TEST(Trigger, AnotherDeviceIsAskedAgain) {
  Person person(by_trigger());
  const auto send = [&person](double time, const std::string& sender, float linear) {
    StickMessage message = pad_at(time, 0.0F, linear);
    message.sender = sender;
    person.machine.receive(message);
    return person.cycle(time).state;
  };
  send(1.0, "/one", 0.0F);
  EXPECT_EQ(send(1.05, "/one", 0.5F), State::shared);
  send(1.1, "/one", 0.0F);
  send(1.15, "/other", 0.0F);
  EXPECT_NE(send(1.2, "/other", 1.0F), State::shared);
  EXPECT_NE(person.machine.advice().find("axes[5] led to its end 1"), std::string::npos);
}

}  // namespace
}  // namespace hidwa_local_planner::input
