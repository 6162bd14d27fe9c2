// SPDX-License-Identifier: BSD-3-Clause
// A Twist in the stick's place.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

Parameters by_twist(OperatorMode mode = OperatorMode::joystick, LinearPolicy linear = LinearPolicy::v_max) {
  Parameters p = in_mode(mode);
  p.twist_topic = "operator_twist";
  p.linear = linear;
  return p;
}

CycleFeedback driving_at(double v) {
  CycleFeedback feedback;
  feedback.command = {v, 0.2};
  return feedback;
}

TEST(Twist, IsTheWishItself) {
  for (const LinearPolicy linear : {LinearPolicy::v_max, LinearPolicy::axis}) {
    Person person(by_twist(OperatorMode::joystick, linear));
    EXPECT_EQ(person.cycle_with_twist(1.0, 0.0, 0.0).state, State::autonomy);
    expect_shared(person.cycle_with_twist(1.05, 0.123, -0.456), 0.123, -0.456);
    expect_shared(person.cycle_with_twist(1.1, -3.0, 7.0), -3.0, 7.0);  // u_h is not clipped
    expect_shared(person.cycle_with_twist(1.2, 0.3, 0.0), 0.3, 0.0);
    expect_hold(person.cycle_with_twist(1.25, 0.0, 0.0), 0.3);  // v_h at release
    EXPECT_EQ(person.cycle(3.19).state, State::hold);           // 3.19 - 1.2 = 1.99 < delta = 2
    EXPECT_EQ(person.cycle(3.21).state, State::autonomy);
  }
}

// Mappers and filters hardly ever send 0: 0.005 m/s and 0.01 rad/s are the least that counts, each by itself.
TEST(Twist, WhatIsHardlyMoreThanZeroIsNeutral) {
  const double v = std::nextafter(0.005, 0.0), omega = std::nextafter(0.01, 0.0);
  for (const Twist2& rest : {Twist2{1e-17, 0.0}, Twist2{0.003, 0.0}, Twist2{v, omega}, Twist2{-v, -omega},
                             Twist2{0.0, 5e-324}, Twist2{-0.0, -0.0}}) {
    Person person(by_twist());
    person.twist(1.0, rest.v, rest.omega);  // arms it
    expect_shared(person.cycle_with_twist(1.05, 0.3, 0.2), 0.3, 0.2);
    expect_hold(person.cycle_with_twist(1.1, rest.v, rest.omega), 0.3);  // a release, and no wish to stand
    EXPECT_EQ(person.cycle_with_twist(3.3, rest.v, rest.omega).state, State::autonomy);
  }
  for (const Twist2& wish : {Twist2{0.005, 0.0}, Twist2{0.0, 0.01}, Twist2{0.0, -0.01}, Twist2{-0.005, 0.001}}) {
    Person person(by_twist());
    person.twist(1.0, 0.0, 0.0);
    expect_shared(person.cycle_with_twist(1.05, wish.v, wish.omega), wish.v, wish.omega);
  }
}

TEST(Twist, TheRobotsOwnSpeedWhereThatIsThePolicy) {
  Person person(by_twist(OperatorMode::joystick, LinearPolicy::current));
  person.cycle_with(twist_at(1.0, 0.0, 0.0), driving_at(0.4));
  expect_shared(person.cycle_with(twist_at(1.05, 0.1, 0.6), driving_at(0.35)), 0.4, 0.6);
  expect_hold(person.cycle_with_twist(1.1, 0.0, 0.0), 0.35);
}

// No command was driven yet whose speed the hold could keep: the Twist's own does not count, so it is 0.
TEST(Twist, WithTheRobotsOwnSpeedAHoldBeforeTheFirstCommandStands) {
  Person person(by_twist(OperatorMode::joystick, LinearPolicy::current));
  person.twist(1.0, 0.0, 0.0);
  person.machine.update(1.0);
  person.twist(1.05, 0.3, 0.6);
  expect_shared(person.machine.update(1.05), 0.0, 0.6);
  person.twist(1.1, 0.0, 0.0);
  expect_hold(person.machine.update(1.1), 0.0);
}

// Whoever has control has all of it.
TEST(Twist, IsTheControlItselfInManual) {
  for (const LinearPolicy linear : {LinearPolicy::v_max, LinearPolicy::axis, LinearPolicy::current}) {
    Person person(by_twist(OperatorMode::switching, linear));
    person.cycle_with(twist_at(1.0, 0.0, 0.0), driving_at(0.4));
    person.machine.take_control(true);
    expect_manual(person.cycle(1.05, driving_at(0.4)), 0.0, 0.0);
    expect_manual(person.cycle_with_twist(1.1, 0.3, -0.7), 0.3, -0.7);
    expect_manual(person.cycle_with_twist(1.15, 0.0, 0.0), 0.0, 0.0);
  }
}

TEST(Twist, TheStickBesideItSteersNothingButItsButtonsCount) {
  Parameters p = by_twist(OperatorMode::switching);
  p.stop_button = static_cast<int>(kStop);
  Person person(p);
  const auto buttons_at = [](double time, int toggle, int stop) {
    StickMessage message;  // no axes at all: none is needed
    message.buttons = {toggle, stop};
    message.received = time;
    return message;
  };
  person.cycle_with(buttons_at(1.0, 0, 0));
  EXPECT_EQ(person.cycle_with(buttons_at(1.3, 1, 0)).state, State::manual);
  EXPECT_EQ(person.cycle_with(buttons_at(1.35, 1, 1)).state, State::stopped);
  EXPECT_EQ(person.cycle_with(buttons_at(1.4, 1, 0)).state, State::manual);
  expect_manual(person.cycle_with_stick(1.45, 1.0F, 1.0F), 0.0, 0.0);  // another shape, another device
  EXPECT_EQ(person.machine.dropped(), 0U);

  Person sharing(by_twist());
  sharing.twist(1.0, 0.0, 0.0);
  sharing.steer(1.0);
  EXPECT_EQ(sharing.cycle(1.1).state, State::autonomy);
}

TEST(Twist, IsNotHeardWithoutItsTopicNorWhereTheHandSteers) {
  Person stick;
  EXPECT_EQ(stick.twist(1.0, kNoNumber, 0.0), "");
  EXPECT_EQ(stick.machine.dropped(), 0U);
  Person hand(by_twist(OperatorMode::gesture));
  hand.twist(1.0, 0.0, 0.0);
  EXPECT_EQ(hand.cycle_with_twist(1.05, 0.3, 0.3).state, State::autonomy);
}

// 100 m/s and 100 rad/s are ten times what a limit may be.
TEST(Twist, NoNumberAndBeyondEveryRobotIsDroppedCountedAndNamed) {
  Person person(by_twist());
  person.twist(1.0, 0.0, 0.0);
  expect_shared(person.cycle_with_twist(1.05, 100.0, -100.0), 100.0, -100.0);
  EXPECT_EQ(person.twist(1.1, kNoNumber, 0.0), "linear.x is not a finite number: look at the sender");
  EXPECT_EQ(person.twist(1.1, 0.0, -HUGE_VAL), "angular.z is not a finite number: look at the sender");
  EXPECT_EQ(person.twist(1.1, 1e300, 0.0),
            "linear.x = 1e+300 is outside [-100, 100] m/s: look at the sender and its units");
  EXPECT_EQ(person.twist(1.1, 0.0, -101.0),
            "angular.z = -101 is outside [-100, 100] rad/s: look at the sender and its units");
  EXPECT_NE(person.twist(kNoNumber, 0.0, 0.0), "");
  EXPECT_EQ(person.machine.dropped(), 5U);
  expect_shared(person.cycle(1.1), 100.0, -100.0);
  EXPECT_EQ(person.cycle(1.6).state, State::lost);  // nor do they keep it alive: 1.6 - 1.05 > 0.5
}

// The good messages of one sender do not hide what is wrong with another's.
TEST(Twist, AFaultIsToldWhileOtherMessagesAreGood) {
  Person person(by_twist());
  EXPECT_NE(person.twist(1.0, kNoNumber, 0.0), "");
  person.stick(1.05, 0.0F);
  EXPECT_TRUE(says(person.machine.advice(), "linear.x"));
  person.twist(1.1, 0.0, 0.0);
  EXPECT_EQ(person.machine.advice(), "");
}

TEST(Twist, AnotherTopicMustBeSeenZero) {
  Person person(by_twist());
  person.twist(1.0, 0.0, 0.0);
  person.cycle_with_twist(1.05, 0.3, 0.0);
  person.p.twist_topic = "other_twist";
  person.configure();
  EXPECT_EQ(person.cycle_with_twist(1.1, 0.3, 0.0).state, State::hold);
  person.p.twist_topic = "";  // back to the stick
  person.configure();
  EXPECT_EQ(person.steer(1.15).state, State::shared);
}

TEST(Twist, TwoSendersInTurnAreNamed) {
  Person person(by_twist());
  for (int i = 0; i < 20; ++i) {
    person.machine.receive(from(i % 2 == 0 ? "/keyboard" : "/mapper", twist_at(1.0 + 0.05 * i, 0.0, 0.0)));
  }
  EXPECT_TRUE(says(person.machine.advice(), "twist_topic"));
}

}  // namespace
}  // namespace hidwa_local_planner::input
