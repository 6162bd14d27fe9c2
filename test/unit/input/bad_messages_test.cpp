// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

TEST(BadMessages, AreDroppedCountedAndNamed) {
  Person person;
  person.steer(1.0);
  EXPECT_TRUE(says(person.stick(1.1, kNan), "axes[0] is not a finite number"));
  EXPECT_TRUE(says(person.stick(1.1, 1.5F), "outside [-1, 1]"));
  StickMessage empty;
  empty.received = 1.1;
  EXPECT_TRUE(says(person.machine.receive(empty), "axis_angular = 0"));
  EXPECT_EQ(person.machine.dropped(), 3U);
  EXPECT_TRUE(says(person.machine.advice(), "dropped"));
  expect_shared(person.cycle(1.1), 0.5, 1.0);  // the last good one still counts
  EXPECT_EQ(person.stick(1.15, 1.0F), "");
  EXPECT_EQ(person.machine.advice(), "");
  EXPECT_EQ(person.machine.dropped(), 3U);
}

TEST(BadMessages, TimesThatAreNoNumbers) {
  Person person;
  person.steer(1.0);
  EXPECT_NE(person.stick(kNoNumber, 1.0F), "");
  EXPECT_NE(person.machine.receive(stamped(HUGE_VAL, stick_at(1.1, 1.0F))), "");
  EXPECT_EQ(person.machine.dropped(), 2U);
  EXPECT_EQ(person.cycle(kNoNumber).state, State::shared);
  EXPECT_EQ(person.cycle(1.1).state, State::shared);
}

struct Dice {
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random() % n); }
  int up_to(int most) { return static_cast<int>(below(static_cast<std::size_t>(most + 1))); }
  int index(int most) { return up_to(most + 1) - 1; }  // of an axis or a button; -1: none
  bool one_in(std::size_t n) { return below(n) == 0; }
  template <typename Value, std::size_t n>
  Value pick(const Value (&values)[n]) {
    return values[below(n)];
  }

  Parameters parameters() {
    Parameters p;
    p.mode = static_cast<OperatorMode>(up_to(3));
    p.twist_topic = one_in(2) ? "" : "operator_twist";
    p.axis_angular = {up_to(2)};
    p.axis_linear = {up_to(2)};
    p.clutch_axis = {index(2)};
    p.enable_button = index(2);
    p.stop_button = index(2);
    p.linear = static_cast<LinearPolicy>(up_to(2));
    p.require_neutral = one_in(2);
    p.on_input_lost = static_cast<OnInputLost>(up_to(2));
    return p;
  }
  // Of any shape, or of the usual one.
  StickMessage stick(double now) {
    const float values[] = {kNan, -HUGE_VALF, -1e30F, -1.01F, -1.0F, -0.1F, 0.0F, 0.3F, 1.0F, 2.0F};
    StickMessage message = stick_at(now, pick(values), pick(values));
    if (one_in(2)) {
      message.axes.resize(below(5), pick(values));
      message.buttons.resize(below(5));
    }
    for (int& button : message.buttons) button = up_to(7) / 3 - (one_in(20) ? 1 : 0);  // a 2 or a -1 now and then
    return message;
  }
  HandMessage hand(double now) {
    HandMessage message = hand_at(now, pick(numbers), pick(numbers), pick(numbers));
    if (one_in(4)) message.orientation = {pick(numbers), pick(numbers), pick(numbers), pick(numbers)};
    return message;
  }
  TwistMessage twist(double now) { return twist_at(now, pick(numbers), pick(numbers)); }

  const double numbers[7] = {kNoNumber, -HUGE_VAL, -1e30, -0.5, 0.0, 0.2, 1.0};
  std::mt19937 random{20220731};
};

/// Whatever arrives: never an exception, every fault is counted, and every command is finite and within the maxima,
/// unless a Twist steers. Returns whether there is one.
bool expect_no_harm(Person& person, const OperatorMessage& message) {
  const std::uint32_t before = person.machine.dropped();
  std::string fault;
  EXPECT_NO_THROW(fault = person.machine.receive(message));
  EXPECT_EQ(person.machine.dropped(), before + (fault.empty() ? 0U : 1U));
  const OperatorIntent intent = person.cycle(message.received);
  EXPECT_TRUE(is_finite(intent.u_h));
  if (!TwistSource().can_steer(person.p)) {
    EXPECT_LE(std::abs(intent.u_h.v), person.p.max_vel_x);
    EXPECT_LE(std::abs(intent.u_h.omega), person.p.max_vel_theta);
  }
  return !(intent.u_h == Twist2{});
}

// Of everything that can steer, in every mode, with words in between and clocks that are set.
TEST(BadMessages, RandomOnesNeverMakeACommand) {
  Dice dice;
  int steered = 0;
  for (int run = 0; run < 600 && !testing::Test::HasFailure(); ++run) {
    Person person(dice.parameters());
    double now = 10.0;
    for (int i = 0; i < 200; ++i) {
      now += 0.01 * dice.up_to(19) - (dice.one_in(100) ? 5.0 : 0.0);
      const double stamp = dice.one_in(2) ? 0.0 : now + dice.up_to(4) - 2.0;
      if (dice.one_in(50)) person.machine.take_control(dice.one_in(2));
      if (dice.one_in(100)) person.machine.stop(dice.one_in(2));
      if (dice.one_in(3)) {
        steered += expect_no_harm(person, stamped(stamp, dice.twist(now)));
      } else if (dice.one_in(2)) {
        steered += expect_no_harm(person, stamped(stamp, dice.hand(now)));
      } else {
        steered += expect_no_harm(person, stamped(stamp, dice.stick(now)));
      }
    }
  }
  EXPECT_GT(steered, 1000);  // good ones among them did
}

}  // namespace
}  // namespace hidwa_local_planner::input
