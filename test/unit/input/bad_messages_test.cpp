// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(BadMessages, AreDroppedCountedAndNamed) {
  Person person;
  person.steer(1.0);
  EXPECT_EQ(person.stick(1.1, kNan),
            "axes[0] is not a finite number: look at the sender, or set axis_angular to another axis");
  EXPECT_NE(person.stick(1.1, 1.5F).find("outside [-1, 1]"), std::string::npos);
  StickMessage empty;
  empty.received = 1.1;
  EXPECT_NE(person.machine.receive(empty).find("axis_angular = 0"), std::string::npos);
  EXPECT_EQ(person.machine.dropped(), 3U);
  EXPECT_NE(person.machine.advice().find("dropped"), std::string::npos);
  expect_intent(person.cycle(1.1), State::shared, Influence::shared, 0.5,
                1.0);  // the last good one still counts
  EXPECT_EQ(person.stick(1.15, 1.0F), "");
  EXPECT_EQ(person.machine.advice(), "");
  EXPECT_EQ(person.machine.dropped(), 3U);
}

TEST(BadMessages, DoNotKeepInputAlive) {
  Person person;
  person.steer(1.0);  // active at 1.05
  for (int i = 1; i < 40; ++i) {
    const double now = 1.05 + 0.05 * i;
    person.stick(now, kNan);
    EXPECT_EQ(person.cycle(now + 1e-3).state, now <= 1.52 ? State::shared : State::lost) << now;  // 0.5 s from 1.05
  }
}

TEST(BadMessages, AreNoNeutral) {
  Person person;
  person.stick(1.0, kNan);
  person.stick(1.05, 1.0F);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
}

TEST(BadMessages, TimesThatAreNoNumbers) {
  Person person;
  person.steer(1.0);
  StickMessage message = stick_at(std::numeric_limits<double>::quiet_NaN(), 1.0F);
  EXPECT_NE(person.machine.receive(message), "");
  message = stick_at(1.1, 1.0F);
  message.stamp = std::numeric_limits<double>::infinity();
  EXPECT_NE(person.machine.receive(message), "");
  EXPECT_EQ(person.machine.dropped(), 2U);
  EXPECT_EQ(person.cycle(std::numeric_limits<double>::quiet_NaN()).state, State::shared);
  EXPECT_EQ(person.cycle(1.1).state, State::shared);
}

TEST(BadMessages, TheCountOutlivesAReset) {
  Person person;
  person.stick(1.0, kNan);
  person.machine.reset();
  EXPECT_EQ(person.machine.dropped(), 1U);
}

// Whatever arrives: never an exception, and every command is finite and within the maxima.
TEST(BadMessages, RandomOnesNeverMakeACommand) {
  const float values[] = {kNan, std::numeric_limits<float>::infinity(), -1e30F, -1.01F, -1.0F, -0.1F, 0.0F, 0.3F, 1.0F,
                          2.0F};
  std::mt19937 random(20220731);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (int run = 0; run < 200; ++run) {
    Parameters p;
    p.axis_angular = {static_cast<int>(below(3))};
    p.axis_linear = {static_cast<int>(below(3))};
    p.enable_button = static_cast<int>(below(4)) - 1;
    p.linear = below(2) == 0 ? LinearPolicy::v_max : LinearPolicy::axis;
    p.require_neutral = below(2) == 0;
    p.on_input_lost = static_cast<OnInputLost>(below(3));
    Person person(p);
    double now = 10.0;
    std::uint32_t dropped = 0;
    for (int i = 0; i < 200; ++i) {
      now += 0.01 * static_cast<double>(below(20)) - (below(100) == 0 ? 5.0 : 0.0);
      StickMessage message;
      message.received = now;
      if (below(2) == 0) message.stamp = now + static_cast<double>(below(5)) - 2.0;
      for (std::size_t n = below(5); n > 0; --n) message.axes.push_back(values[below(std::size(values))]);
      for (std::size_t n = below(5); n > 0; --n) message.buttons.push_back(static_cast<int>(below(4)) - 1);
      std::string fault;
      ASSERT_NO_THROW(fault = person.machine.receive(message));
      dropped += fault.empty() ? 0U : 1U;
      ASSERT_EQ(person.machine.dropped(), dropped);
      const OperatorIntent intent = person.cycle(now);
      ASSERT_TRUE(is_finite(intent.u_h));
      ASSERT_LE(std::abs(intent.u_h.v), p.max_vel_x);
      ASSERT_LE(std::abs(intent.u_h.omega), p.max_vel_theta);
    }
  }
}

// The same for everything that can steer, in every mode, with words in between.
TEST(BadMessages, RandomOnesOfEveryKindNeverMakeACommand) {
  const double values[] = {
      std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity(), -1e30, -0.5, 0.0, 0.2, 1.0};
  const float axes[] = {kNan, -1.5F, -1.0F, 0.0F, 0.4F, 1.0F};
  std::mt19937 random(20220801);
  const auto below = [&random](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const auto value = [&] { return values[below(std::size(values))]; };
  int steered = 0;
  for (int run = 0; run < 400; ++run) {
    Parameters p;
    p.mode = static_cast<OperatorMode>(below(4));
    p.twist_topic = below(2) == 0 ? "" : "operator_twist";
    p.linear = static_cast<LinearPolicy>(below(3));
    p.clutch_axis = {static_cast<int>(below(4)) - 1};
    p.stop_button = static_cast<int>(below(4)) - 1;
    p.require_neutral = below(2) == 0;
    Person person(p);
    double now = 10.0;
    std::uint32_t dropped = 0;
    for (int i = 0; i < 200; ++i) {
      now += 0.01 * static_cast<double>(below(20));
      std::string fault;
      if (below(3) == 0) {
        fault = person.twist(now, value(), value());
      } else if (below(2) == 0) {
        HandMessage message = hand_at(now, value(), value(), value());
        if (below(4) == 0) message.orientation = {value(), value(), value(), value()};
        fault = person.machine.receive(message);
      } else {
        StickMessage message = stick_at(now, axes[below(std::size(axes))], axes[below(std::size(axes))]);
        for (int& button : message.buttons) button = static_cast<int>(below(8)) / 3;  // a 2 now and then
        fault = person.machine.receive(message);
      }
      if (below(50) == 0) person.machine.take_control(below(2) == 0);
      if (below(100) == 0) person.machine.stop(below(2) == 0);
      dropped += fault.empty() ? 0U : 1U;
      ASSERT_EQ(person.machine.dropped(), dropped);
      const OperatorIntent intent = person.cycle(now);
      ASSERT_TRUE(is_finite(intent.u_h));
      if (!TwistSource().can_steer(p)) {
        ASSERT_LE(std::abs(intent.u_h.v), p.max_vel_x);
        ASSERT_LE(std::abs(intent.u_h.omega), p.max_vel_theta);
      }
      if (!(intent.u_h == Twist2{})) ++steered;
    }
  }
  EXPECT_GT(steered, 1000);  // good ones among them did
}

}  // namespace
}  // namespace hidwa_local_planner::input
