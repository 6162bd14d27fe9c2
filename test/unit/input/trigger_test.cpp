// SPDX-License-Identifier: BSD-3-Clause
// A speed axis that does not rest at 0: a trigger, a pedal, a lever. Its driver sends 0 until it is touched.
#include <string>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

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
    EXPECT_EQ(person.cycle_with_stick(1.0, 0.0F, 0.0F).state, State::autonomy);  // not touched yet
    EXPECT_EQ(person.cycle_with_stick(1.05, 0.0F, end).state, State::autonomy);
    expect_shared(person.cycle_with_stick(1.1, 0.0F, -end), 0.5, 0.0);
    // Half pressed: it has moved, so that 0 is 0 now.
    expect_shared(person.cycle_with_stick(1.15, 0.0F, 0.0F), 0.125, 0.0);
    EXPECT_EQ(person.cycle_with_stick(1.2, 0.0F, end).state, State::hold);
    EXPECT_EQ(person.machine.advice(), "");
  }
}

// The rest of a worn stick, 0.15: the way to 1 is 0.85, and 1.15 is as far to the other side. 0.15 + 1.15 x 0.5 =
// 0.725.
TEST(Trigger, AnyRestCanBeGiven) {
  Person person(by_axis(0.15, 1));
  person.stick(1.0, 0.0F, 0.15F);
  EXPECT_NEAR(person.cycle_with_stick(1.05, 0.0F, 0.725F).u_h.v, 0.125, 1e-6);
  EXPECT_EQ(person.cycle_with_stick(1.1, 0.0F, 0.15F).state, State::hold);
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
    ASSERT_EQ(person.cycle_with(pad_at(2.0 + 0.05 * i, 0.0F, 1.0F)).state, State::autonomy) << i;
  }
  for (const char* part : {"axes[5] led to its end 1", "axis_linear_rest to 1"}) {
    EXPECT_TRUE(says(person.machine.advice(), part)) << person.machine.advice();
  }
  float value = 1.0F;  // pressed and let go, through its centre; beyond -0.8 it would be a pull
  for (int i = 0; i <= 34; ++i, value -= i < 17 ? 0.1F : -0.1F) {
    ASSERT_EQ(person.cycle_with(pad_at(7.0 + 0.05 * i, 0.0F, value)).state, State::autonomy) << value;
  }
  expect_shared(person.cycle_with(pad_at(9.1, 1.0F, 1.0F)), 0.0, 1.0);  // the other axis steers, at rest
}

// A key or a cross of keys: from its second pressure on it counts, once it was let go for a second.
TEST(Trigger, WhatStandsInItsCentreForASecondIsNone) {
  Person person(by_trigger());
  person.machine.receive(pad_at(1.0, 0.0F, 0.0F));
  EXPECT_EQ(person.cycle_with(pad_at(1.05, 0.0F, 1.0F)).state, State::autonomy);
  person.machine.receive(pad_at(1.1, 0.0F, 0.1F));                                // within dead_zone
  EXPECT_EQ(person.cycle_with(pad_at(2.05, 0.0F, 1.0F)).state, State::autonomy);  // 0.95 s later
  person.machine.receive(pad_at(3.0, 0.0F, 0.0F));
  expect_shared(person.cycle_with(pad_at(4.0, 0.0F, 1.0F)), 0.5, 0.0);
  EXPECT_EQ(person.machine.advice(), "");
}

TEST(Trigger, WhatMovesOnItsWayIsNone) {
  Person person(by_trigger());
  person.machine.receive(pad_at(1.0, 0.0F, 0.0F));
  EXPECT_EQ(person.cycle_with(pad_at(1.05, 0.0F, 0.98F)).state, State::shared);
}

// The first two axes are a stick wherever there is one: pushed to its end at once, as by a key, it drives on.
TEST(Trigger, AStickIsNeverAsked) {
  Person person(by_axis(0.0, 1));
  person.stick(1.0, 0.0F, 0.0F);
  for (int i = 1; i < 200; ++i) {
    ASSERT_EQ(person.cycle_with_stick(1.0 + 0.05 * i, 0.0F, 1.0F).state, State::shared);
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
  EXPECT_EQ(person.cycle_with(pad_at(1.05, 0.0F, 1.0F)).state, State::stopped);
  EXPECT_TRUE(says(person.machine.advice(), "axis_linear_rest to 1"));
  person.p.axis_linear_rest = 1.0;
  person.configure();
  EXPECT_EQ(person.cycle_with(pad_at(1.1, 0.0F, 1.0F)).state, State::autonomy);
  EXPECT_EQ(person.machine.advice(), "");
}

// In mode switching, too: whoever has control does not drive off.
TEST(Trigger, MovesNobodyWhoHasControl) {
  Parameters p = in_mode(OperatorMode::switching);
  p.axis_linear = {5};
  Person person(p);
  person.cycle_with(pad_at(1.0, 0.0F, 0.0F));
  person.machine.take_control(true);
  expect_manual(person.cycle_with(pad_at(1.05, 0.0F, 1.0F)), 0.0, 0.0);
  expect_manual(person.cycle_with(pad_at(1.1, 0.5F, 1.0F)), 0.0, 0.25);  // (0.5)^2 x 1 rad/s
}

TEST(Trigger, OfAnotherDeviceIsAskedForItsCentreAgain) {
  Person person(by_trigger());
  const auto send = [&person](double time, const std::string& sender, float linear) {
    return person.cycle_with(from(sender, pad_at(time, 0.0F, linear))).state;
  };
  send(1.0, "/one", 0.0F);
  EXPECT_EQ(send(1.05, "/one", 0.5F), State::shared);
  send(1.1, "/one", 0.0F);
  send(1.15, "/other", 0.0F);
  EXPECT_NE(send(1.2, "/other", 1.0F), State::shared);
  EXPECT_TRUE(says(person.machine.advice(), "axes[5] led to its end 1"));
}

}  // namespace
}  // namespace hidwa_local_planner::input
