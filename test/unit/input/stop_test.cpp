// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

// stop_pull is 0.8: a pull begins there and goes on down to 0.75 * 0.8 = 0.6.
TEST(Stop, PulledBackWithHysteresis) {
  struct Step {
    float linear;
    bool stops;
  };
  const Step steps[] = {
      {0.0F, false},    // centred
      {-0.79F, false},  // not far enough
      {-0.8F, true},    // a pull
      {-0.61F, true},   // it goes on
      {-1.0F, true},    // it is stronger again
      {-0.59F, false},  // its end
      {-0.7F, false},   // not far enough for a new one
      {1.0F, false},    // forward is no pull
  };
  Person person;
  double time = 1.0;
  for (const Step& step : steps) {
    const bool stopped = person.cycle_with_stick(time, 0.0F, step.linear).state == State::stopped;
    EXPECT_EQ(stopped, step.stops) << step.linear << " at " << time;
    time += 0.05;
  }
}

TEST(Stop, PulledByTheSignOfTheAxis) {
  Parameters p;
  p.axis_linear.reversed = true;  // down is +1
  Person person(p);
  person.stick(1.0, 0.0F);
  EXPECT_EQ(person.cycle_with_stick(1.05, 0.0F, -1.0F).state, State::autonomy);
  expect_stopped(person.cycle_with_stick(1.1, 0.0F, 1.0F));
}

TEST(Stop, PullsOnlyWhereTheyAskForNothingElse) {
  const auto state_when_pulled = [](const Parameters& p) {
    Person person(p);
    person.stick(1.0, 0.0F);
    return person.cycle_with_stick(1.05, 0.0F, -1.0F).state;
  };
  EXPECT_EQ(state_when_pulled(in_mode(OperatorMode::joystick)), State::stopped);
  EXPECT_EQ(state_when_pulled(in_mode(OperatorMode::gesture)), State::stopped);
  EXPECT_EQ(state_when_pulled(in_mode(OperatorMode::switching)), State::autonomy);
  Parameters p;
  p.stop_pull = 0.0;
  EXPECT_EQ(state_when_pulled(p), State::autonomy);
  p = Parameters();
  p.twist_topic = "operator_twist";  // the Twist steers; the stick has no directions
  EXPECT_EQ(state_when_pulled(p), State::autonomy);
  p = Parameters();
  p.linear = LinearPolicy::axis;
  EXPECT_EQ(state_when_pulled(p), State::stopped);
  p.min_vel_x = -0.2;  // then it asks for reverse
  EXPECT_EQ(state_when_pulled(p), State::shared);
}

TEST(Stop, InWordsCountsInEveryModeAndOutlivesItsChange) {
  Person person;
  person.steer(1.0);
  person.machine.stop(true);
  expect_stopped(person.cycle(1.05));
  person.set_mode(OperatorMode::off);
  expect_stopped(person.cycle(9.0));
  person.set_mode(OperatorMode::joystick);
  expect_stopped(person.cycle(9.05));
  person.machine.stop(false);
  EXPECT_EQ(person.cycle(9.1).state, State::autonomy);
  person.set_mode(OperatorMode::off);
  person.machine.stop(true);  // where nobody may steer
  expect_stopped(person.cycle(9.15));
  person.machine.stop(false);
  EXPECT_EQ(person.cycle(9.2).state, State::autonomy);
}

TEST(Stop, OutlivesAChangeOfMode) {
  Person person(with_stop_button());
  expect_stopped(person.cycle_with_button(1.0, kStop));
  person.set_mode(OperatorMode::switching);
  expect_stopped(person.cycle(1.05));
  // Nobody listens to the device any more, and whoever changed the mode let go of it.
  person.set_mode(OperatorMode::off);
  expect_stopped(person.cycle(1.1));
  expect_stopped(person.cycle(1.95));
  expect_autonomy(person.cycle(2.05));  // 1 s after the device's last message
  EXPECT_TRUE(says(person.machine.take_warnings(), "has ended"));
}

TEST(Stop, APullGoesOnWhereAnotherButtonIsChosen) {
  Person person;
  person.stick(1.0, 0.0F);
  expect_stopped(person.cycle_with_stick(1.05, 0.0F, -1.0F));
  person.p.stop_button = static_cast<int>(kStop);
  person.configure();
  expect_stopped(person.cycle_with_stick(1.1, 0.0F, -1.0F));
  EXPECT_EQ(person.cycle_with_stick(1.15, 0.0F).state, State::autonomy);
}

TEST(Stop, AnotherDeviceThatLiesPulledDoesNotStop) {
  const std::string other = "/another_joy_node";
  Person person;
  person.cycle_with_stick(1.0, 0.0F);
  EXPECT_EQ(person.cycle_with(from(other, stick_at(1.05, 0.0F, -1.0F))).state, State::autonomy);
  person.machine.receive(from(other, stick_at(1.1, 0.0F)));
  expect_stopped(person.cycle_with(from(other, stick_at(1.15, 0.0F, -1.0F))));
}

// Whatever else the message holds: what is wrong with it drops its steering, not its stop.
TEST(Stop, FromAMessageThatIsFaultyElsewhere) {
  constexpr double kNoTime = std::numeric_limits<double>::quiet_NaN();
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  struct Row {
    const char* message;
    std::vector<float> axes;   // turn, speed
    std::vector<int> buttons;  // toggle, stop
    double stamp;
    bool stops;
  };
  const Row rows[] = {
      {"a press, and the turn is no number", {kNan, 0.0F}, {0, 1}, 0.0, true},
      {"a press, and the speed is no number", {0.0F, kNan}, {0, 1}, 0.0, true},
      {"a press, and the turn is out of range", {1.2F, 0.0F}, {0, 1}, 0.0, true},
      {"a press, and there are no axes", {}, {0, 1}, 0.0, true},
      {"a press, and the stamp is no number", {0.0F, 0.0F}, {0, 1}, kNoTime, true},
      {"a press that is said by 2", {0.0F, 0.0F}, {0, 2}, 0.0, true},
      {"a pull, and the turn is no number", {kNan, -1.0F}, {0, 0}, 0.0, true},
      {"a pull, and there are no buttons", {0.0F, -1.0F}, {}, 0.0, true},
      {"a pull beyond the range", {0.0F, -1.2F}, {0, 0}, 0.0, true},
      {"no stop, and the speed is no number", {0.0F, kNan}, {0, 0}, 0.0, false},
      {"no stop, and the speed is infinite", {0.0F, kInfinite}, {0, 0}, 0.0, false},
      {"no stop, and the speed is out of range", {0.0F, 1.5F}, {0, 0}, 0.0, false},
      {"no stop, and there are no buttons", {0.0F, 0.0F}, {}, 0.0, false},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.message);
    Person person(with_stop_button());
    EXPECT_EQ(person.cycle_with_stick(1.0, 0.0F).state, State::autonomy);
    StickMessage message = stamped(row.stamp, stick_at(1.05, 0.0F));
    message.axes = row.axes;
    message.buttons = row.buttons;
    EXPECT_NE(person.machine.receive(message), "");
    EXPECT_EQ(person.machine.dropped(), 1U);
    EXPECT_EQ(person.cycle(1.05).state, row.stops ? State::stopped : State::autonomy);
    EXPECT_EQ(person.cycle_with_stick(1.1, 0.0F).state, State::autonomy);  // one in order lets go
  }
}

/// The message of a node whose stop button is held, or is not.
StickMessage stop_of(const std::string& sender, double time, bool held) {
  StickMessage message = from(sender, stick_at(time, 0.0F));
  message.buttons[kStop] = held ? 1 : 0;
  return message;
}

TEST(Stop, BesideATwistAndAHandToo) {
  Parameters p = with_stop_button();
  p.twist_topic = "operator_twist";
  Person by_twist(p);
  by_twist.twist(1.0, 0.0, 0.0);
  EXPECT_EQ(by_twist.cycle_with_twist(1.05, 0.3, 0.3).state, State::shared);
  expect_stopped(by_twist.cycle_with(stamped(HUGE_VAL, stop_of("/joy", 1.1, true))));
  EXPECT_EQ(by_twist.machine.dropped(), 1U);
  expect_stopped(by_twist.cycle_with_twist(1.15, 0.3, 0.3));  // another sender's message

  p = with_stop_button(OperatorMode::gesture);
  p.clutch_axis = {3};  // the device does not have it
  Person by_hand(p);
  by_hand.hand(1.0, 0.0);
  expect_stopped(by_hand.cycle_with(stop_of("/joy", 1.05, true)));
  EXPECT_EQ(by_hand.machine.dropped(), 1U);
  expect_stopped(by_hand.cycle_with(hand_at(1.1, 1.0, 0.0, 1.0)));
}

TEST(Stop, EverySenderHasItsOwn) {
  Person person(with_stop_button());
  person.machine.receive(stop_of("/first", 1.0, false));
  expect_stopped(person.cycle_with(stop_of("/second", 1.05, true)));
  for (int i = 0; i < 40; ++i) expect_stopped(person.cycle_with(stop_of("/first", 1.1 + 0.05 * i, false)));
  person.machine.receive(stop_of("/first", 3.1, true));
  expect_stopped(person.cycle_with(stop_of("/second", 3.15, false)));
  EXPECT_EQ(person.cycle_with(stop_of("/first", 3.2, false)).state, State::autonomy);
}

// Two that take turns are new devices after each other, and each of them stops at once.
TEST(Stop, ByAPullOfOneOfTwoThatTakeTurns) {
  Person person;
  const auto send = [&](const std::string& sender, double time, float along) {
    return person.cycle_with(from(sender, stick_at(time, 0.0F, along))).state;
  };
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(send("/first", 1.0 + 0.05 * i, 0.0F), State::autonomy);
    EXPECT_EQ(send("/second", 1.02 + 0.05 * i, 0.0F), State::autonomy);
  }
  EXPECT_EQ(send("/first", 1.5, -1.0F), State::stopped);
  EXPECT_EQ(send("/second", 1.52, 0.0F), State::stopped);
  EXPECT_EQ(send("/first", 1.55, 0.0F), State::autonomy);
}

TEST(Stop, OfADeviceThatDiedEndsInWords) {
  Person person(with_stop_button());
  expect_stopped(person.cycle_with(stop_of("/joy_1", 1.0, true)));
  for (double time = 1.05; time < 5.0; time += 0.05) {
    expect_stopped(person.cycle_with(stop_of("/joy_2", time, false)));  // its successor
  }
  EXPECT_TRUE(says(person.machine.advice(), "The stop of /joy_1 goes on")) << person.machine.advice();
  EXPECT_EQ(person.machine.take_warnings(), "");
  person.machine.stop(false);
  EXPECT_EQ(person.cycle(5.0).state, State::autonomy);
  EXPECT_EQ(person.machine.take_warnings(),
            "The stop of /joy_1, which asked for it last 4 s ago, has ended: the topic stop or a change of mode "
            "released it.");
  EXPECT_EQ(person.machine.take_warnings(), "");
  EXPECT_FALSE(says(person.machine.advice(), "/joy_1 goes on"));
}

// A stick that sends only changes is silent while its button is held: that is no fault.
TEST(Stop, OfADeviceThatMayBeSilentIsNoFault) {
  for (const double timeout : {0.0, 0.5}) {
    Parameters p = with_stop_button();
    p.input_timeout = timeout;
    Person person(p);
    expect_stopped(person.cycle_with_button(1.0, kStop));
    expect_stopped(person.cycle(100.0));
    EXPECT_EQ(says(person.machine.advice(), "goes on, though no message of it came lately"), timeout > 0.0);
  }
}

TEST(Stop, NamesWithoutNumberDoNotPileUp) {
  Person person(with_stop_button());
  person.machine.receive(stop_of("/holds", 1.0, true));
  const auto bytes_after = [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      person.machine.receive(stop_of("/joy_" + std::to_string(100 + i), 1.0 + 0.01 * i, false));
    }
    return saved(person.machine).size();
  };
  const std::size_t few = bytes_after(0, 100);
  EXPECT_EQ(bytes_after(100, 800), few);
  expect_stopped(person.cycle(9.0));
}

// 16 are remembered, itself among them: of a stick whose node was forgotten a pull counts only once it was seen
// otherwise.
TEST(Stop, SixteenNamesAreRemembered) {
  for (const int others : {15, 16}) {
    StopRequest stop;
    StopReading reading;
    reading.shape = {2, 2};
    const auto pull_of = [&](const std::string& name, float back) {
      reading.back = back;
      stop.take("stick", name, reading, true, Parameters(), 1.0);
    };
    pull_of("/first", 0.0F);
    for (int i = 0; i < others; ++i) pull_of("/joy_" + std::to_string(i), 0.0F);
    EXPECT_FALSE(stop.requested());
    pull_of("/first", 1.0F);
    EXPECT_EQ(stop.requested(), others == 15);
  }
}

}  // namespace
}  // namespace hidwa_local_planner::input
