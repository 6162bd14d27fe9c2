// SPDX-License-Identifier: BSD-3-Clause
// A Twist in the stick's place.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;

Parameters by_twist(OperatorMode mode = OperatorMode::joystick) {
  Parameters p;
  p.twist_topic = "operator_twist";
  p.mode = mode;
  return p;
}

CycleFeedback driving_at(double v) {
  CycleFeedback feedback;
  feedback.command = {v, 0.2};
  return feedback;
}

TEST(Twist, IsTheWishItself) {
  for (const LinearPolicy linear : {LinearPolicy::v_max, LinearPolicy::axis}) {
    Parameters p = by_twist();  // max_vel_x 0.5, max_vel_theta 1, dead_zone 0.1
    p.linear = linear;
    Person person(p);
    person.twist(1.0, 0.0, 0.0);
    EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
    person.twist(1.05, 0.123, -0.456);
    expect_intent(person.cycle(1.05), State::shared, Influence::shared, 0.123, -0.456);
    person.twist(1.1, -3.0, 7.0);  // u_h is not clipped
    expect_intent(person.cycle(1.1), State::shared, Influence::shared, -3.0, 7.0);
    person.twist(1.15, 0.0, 0.01);  // the slowest that counts
    expect_intent(person.cycle(1.15), State::shared, Influence::shared, 0.0, 0.01);
    person.twist(1.2, 0.3, 0.0);
    expect_intent(person.cycle(1.2), State::shared, Influence::shared, 0.3, 0.0);
    person.twist(1.25, 0.0, 0.0);
    expect_intent(person.cycle(1.25), State::hold, Influence::shared, 0.3, 0.0);  // v_h at release
    EXPECT_EQ(person.cycle(3.19).state, State::hold);                             // 3.19 - 1.2 = 1.99 < delta = 2
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
    person.twist(1.05, 0.3, 0.2);
    expect_intent(person.cycle(1.05), State::shared, Influence::shared, 0.3, 0.2);
    person.twist(1.1, rest.v, rest.omega);  // a release, and no wish to stand
    expect_intent(person.cycle(1.1), State::hold, Influence::shared, 0.3, 0.0);
    person.twist(3.3, rest.v, rest.omega);
    EXPECT_EQ(person.cycle(3.3).state, State::autonomy);
  }
  for (const Twist2& wish : {Twist2{0.005, 0.0}, Twist2{0.0, -0.01}, Twist2{-0.005, 0.001}}) {
    Person person(by_twist());
    person.twist(1.0, 0.0, 0.0);
    person.twist(1.05, wish.v, wish.omega);
    expect_intent(person.cycle(1.05), State::shared, Influence::shared, wish.v, wish.omega);
  }
}

TEST(Twist, TheRobotsOwnSpeedWhereThatIsThePolicy) {
  Parameters p = by_twist();
  p.linear = LinearPolicy::current;
  Person person(p);
  person.twist(1.0, 0.0, 0.0);
  person.cycle(1.0, driving_at(0.4));
  person.twist(1.05, 0.1, 0.6);
  expect_intent(person.cycle(1.05, driving_at(0.35)), State::shared, Influence::shared, 0.4, 0.6);
  person.twist(1.1, 0.0, 0.0);
  expect_intent(person.cycle(1.1), State::hold, Influence::shared, 0.35, 0.0);
}

// No command was driven yet whose speed the hold could keep: the Twist's own does not count, so it is 0.
TEST(Twist, WithTheRobotsOwnSpeedAHoldBeforeTheFirstCommandStands) {
  Parameters p = by_twist();
  p.linear = LinearPolicy::current;
  Person person(p);
  person.twist(1.0, 0.0, 0.0);
  person.machine.update(1.0);
  person.twist(1.05, 0.3, 0.6);
  expect_intent(person.machine.update(1.05), State::shared, Influence::shared, 0.0, 0.6);
  person.twist(1.1, 0.0, 0.0);
  expect_intent(person.machine.update(1.1), State::hold, Influence::shared, 0.0, 0.0);
}

// Whoever has control has all of it.
TEST(Twist, IsTheControlItselfInManual) {
  for (const LinearPolicy linear : {LinearPolicy::v_max, LinearPolicy::axis, LinearPolicy::current}) {
    Parameters p = by_twist(OperatorMode::switching);
    p.linear = linear;
    Person person(p);
    person.twist(1.0, 0.0, 0.0);
    person.cycle(1.0, driving_at(0.4));
    person.machine.take_control(true);
    expect_intent(person.cycle(1.05, driving_at(0.4)), State::manual, Influence::direct, 0.0, 0.0);
    person.twist(1.1, 0.3, -0.7);
    expect_intent(person.cycle(1.1), State::manual, Influence::direct, 0.3, -0.7);
    person.twist(1.15, 0.0, 0.0);
    expect_intent(person.cycle(1.15), State::manual, Influence::direct, 0.0, 0.0);
  }
}

TEST(Twist, MustBeSeenZeroOnce) {
  Person person(by_twist());
  person.twist(1.0, 0.3, 0.0);
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
  EXPECT_NE(person.machine.advice().find("require_neutral"), std::string::npos);
  person.twist(1.05, 0.0, 0.0);
  person.twist(1.1, 0.3, 0.0);
  EXPECT_EQ(person.cycle(1.1).state, State::shared);
}

TEST(Twist, TheStickBesideItSteersNothingButItsButtonsCount) {
  Parameters p = by_twist(OperatorMode::switching);
  p.stop_button = 1;
  Person person(p);
  StickMessage buttons;  // no axes at all: none is needed
  buttons.buttons = {0, 0};
  const auto press = [&](double time, std::size_t button, int value) {
    buttons.received = time;
    buttons.buttons[button] = value;
    EXPECT_EQ(person.machine.receive(buttons), "");
  };
  press(1.0, 0, 0);
  person.cycle(1.0);
  press(1.3, 0, 1);
  EXPECT_EQ(person.cycle(1.3).state, State::manual);
  press(1.35, 1, 1);
  EXPECT_EQ(person.cycle(1.35).state, State::stopped);
  press(1.4, 1, 0);
  EXPECT_EQ(person.cycle(1.4).state, State::manual);
  buttons.axes = {1.0F, 1.0F};  // another shape, another device
  press(1.45, 0, 0);
  expect_intent(person.cycle(1.45), State::manual, Influence::direct, 0.0, 0.0);

  Person sharing(by_twist());
  sharing.twist(1.0, 0.0, 0.0);
  sharing.steer(1.0);
  EXPECT_EQ(sharing.cycle(1.1).state, State::autonomy);
}

TEST(Twist, IsNotHeardWithoutItsTopicNorWhereTheHandSteers) {
  Person stick;
  EXPECT_EQ(stick.twist(1.0, std::numeric_limits<double>::quiet_NaN(), 0.0), "");
  EXPECT_EQ(stick.machine.dropped(), 0U);
  Person hand(by_twist(OperatorMode::gesture));
  hand.twist(1.0, 0.0, 0.0);
  hand.twist(1.05, 0.3, 0.3);
  EXPECT_EQ(hand.cycle(1.05).state, State::autonomy);
}

TEST(Twist, NotANumberIsDroppedCountedAndNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Person person(by_twist());
  person.twist(1.0, 0.0, 0.0);
  person.twist(1.05, 0.3, 0.4);
  person.cycle(1.05);
  EXPECT_EQ(person.twist(1.1, nan, 0.0), "linear.x is not a finite number: look at the sender");
  EXPECT_EQ(person.twist(1.1, 0.0, -std::numeric_limits<double>::infinity()),
            "angular.z is not a finite number: look at the sender");
  EXPECT_NE(person.twist(nan, 0.0, 0.0), "");
  EXPECT_EQ(person.machine.dropped(), 3U);
  expect_intent(person.cycle(1.1), State::shared, Influence::shared, 0.3, 0.4);
  EXPECT_EQ(person.cycle(1.6).state, State::lost);  // nor do they keep it alive: 1.6 - 1.05 > 0.5
}

// 100 m/s and 100 rad/s are ten times what a limit may be.
TEST(Twist, BeyondEveryRobotIsDroppedCountedAndNamed) {
  Person person(by_twist());
  person.twist(1.0, 0.0, 0.0);
  EXPECT_EQ(person.twist(1.05, 1e300, 0.0),
            "linear.x = 1e+300 is outside [-100, 100] m/s: look at the sender and its units");
  EXPECT_EQ(person.twist(1.1, 0.0, -101.0),
            "angular.z = -101 is outside [-100, 100] rad/s: look at the sender and its units");
  EXPECT_EQ(person.machine.dropped(), 2U);
  EXPECT_EQ(person.cycle(1.1).state, State::autonomy);
  EXPECT_EQ(person.twist(1.15, 100.0, -100.0), "");
  expect_intent(person.cycle(1.15), State::shared, Influence::shared, 100.0, -100.0);
}

// The good messages of one sender do not hide what is wrong with another's.
TEST(Twist, AFaultIsToldWhileOtherMessagesAreGood) {
  Person person(by_twist());
  EXPECT_NE(person.twist(1.0, std::numeric_limits<double>::quiet_NaN(), 0.0), "");
  person.stick(1.05, 0.0F);
  EXPECT_NE(person.machine.advice().find("linear.x"), std::string::npos);
  person.twist(1.1, 0.0, 0.0);
  EXPECT_EQ(person.machine.advice(), "");
}

TEST(Twist, AnotherTopicMustBeSeenZero) {
  Person person(by_twist());
  person.twist(1.0, 0.0, 0.0);
  person.twist(1.05, 0.3, 0.0);
  person.cycle(1.05);
  person.p.twist_topic = "other_twist";
  person.machine.configure(person.p);
  person.twist(1.1, 0.3, 0.0);
  EXPECT_EQ(person.cycle(1.1).state, State::hold);
  person.p.twist_topic = "";  // back to the stick
  person.machine.configure(person.p);
  person.steer(1.15);
  EXPECT_EQ(person.machine.state(), State::shared);
}

TEST(Twist, TwoSendersInTurnAreNamed) {
  Person person(by_twist());
  for (int i = 0; i < 20; ++i) {
    TwistMessage message = twist_at(1.0 + 0.05 * i, 0.0, 0.0);
    message.sender = i % 2 == 0 ? "/keyboard" : "/mapper";
    person.machine.receive(message);
  }
  EXPECT_NE(person.machine.advice().find("twist_topic"), std::string::npos);
}

}  // namespace
}  // namespace hidwa_local_planner::input
