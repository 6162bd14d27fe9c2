// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;
constexpr std::size_t kToggle = 0;
constexpr std::size_t kStop = 1;

Parameters with_button() {
  Parameters p;
  p.stop_button = static_cast<int>(kStop);
  return p;
}

void expect_stopped(const OperatorIntent& intent) { expect_intent(intent, State::stopped, Influence::stop, 0.0, 0.0); }

CycleFeedback at_goal() {
  CycleFeedback feedback;
  feedback.goal_latched = true;
  return feedback;
}

TEST(Stop, ButtonFromAutonomyWhileItIsHeld) {
  Person person(with_button());
  person.stick(1.0, 0.0F);
  person.cycle(1.0);
  person.button(1.05, kStop);
  expect_stopped(person.cycle(1.05));
  person.button(2.0, kStop);
  expect_stopped(person.cycle(2.0));
  person.stick(2.05, 0.0F);
  expect_intent(person.cycle(2.05), State::autonomy, Influence::none, 0.0, 0.0);
}

TEST(Stop, ButtonWhileSharedAndSharedAgainOnRelease) {
  Person person(with_button());
  person.steer(1.0);
  person.button(1.1, kStop, 1.0F);
  expect_stopped(person.cycle(1.1));
  person.stick(1.15, 1.0F);  // the stick was deflected all along
  expect_intent(person.cycle(1.15), State::shared, Influence::shared, 0.5, 1.0);
}

TEST(Stop, ButtonDuringHoldAndTheHoldDoesNotComeBack) {
  Person person(with_button());
  person.steer(1.0);
  person.stick(1.1, 0.0F);
  EXPECT_EQ(person.cycle(1.1).state, State::hold);
  person.button(1.15, kStop);
  expect_stopped(person.cycle(1.15));
  person.stick(1.2, 0.0F);  // 1.2 - 1.05 < delta
  expect_intent(person.cycle(1.2), State::autonomy, Influence::none, 0.0, 0.0);
}

TEST(Stop, ButtonInPlaceOfTheStickLeavesNoHold) {
  Person person(with_button());
  person.steer(1.0);
  person.button(1.1, kStop);  // let go and stopped in one message
  expect_stopped(person.cycle(1.1));
  person.stick(1.15, 0.0F);
  EXPECT_EQ(person.cycle(1.15).state, State::autonomy);
}

TEST(Stop, ButtonWhileBlocked) {
  Parameters p = with_button();
  p.blocked_time = 0.0;
  Person person(p);
  CycleFeedback rejected;
  rejected.operator_command_rejected = rejected.stands = true;
  person.stick(1.0, 0.0F);
  person.stick(1.05, 1.0F);
  person.cycle(1.05, rejected);
  EXPECT_EQ(person.cycle(1.1, rejected).state, State::blocked);
  person.button(1.15, kStop, 1.0F);
  expect_stopped(person.cycle(1.15, rejected));
  person.stick(1.2, 1.0F);
  EXPECT_EQ(person.cycle(1.2).state, State::shared);  // the blockage is measured anew
}

TEST(Stop, ButtonWhileManualAndManualAgainOnRelease) {
  Parameters p = with_button();
  p.mode = OperatorMode::switching;
  Person person(p);
  person.stick(1.0, 0.0F);
  person.cycle(1.0);
  person.button(1.5, kToggle);
  EXPECT_EQ(person.cycle(1.5).state, State::manual);
  person.button(1.55, kStop, 1.0F, 1.0F);
  expect_stopped(person.cycle(1.55));
  person.stick(1.6, 1.0F, 1.0F);
  expect_intent(person.cycle(1.6), State::manual, Influence::direct, 0.5, 1.0);
}

TEST(Stop, CountsInTheGoalWindow) {
  Person person(with_button());
  person.stick(1.0, 0.0F);
  person.cycle(1.0, at_goal());
  person.stick(1.05, 1.0F);
  EXPECT_EQ(person.cycle(1.05, at_goal()).state, State::autonomy);  // steering does not
  person.button(1.1, kStop, 1.0F);
  expect_stopped(person.cycle(1.1, at_goal()));
  person.stick(1.15, 1.0F);
  EXPECT_EQ(person.cycle(1.15, at_goal()).state, State::autonomy);
}

TEST(Stop, ANewGoalDoesNotEndIt) {
  Person person(with_button());
  person.button(1.0, kStop);
  expect_stopped(person.cycle(1.0));
  person.machine.new_goal();
  expect_stopped(person.cycle(1.05));
}

TEST(Stop, ButtonHeldAtTheStartCountsAtOnce) {
  Person person(with_button());
  person.button(1.0, kStop);
  expect_stopped(person.cycle(1.0));
}

TEST(Stop, WithoutAStopButtonNoButtonStops) {
  Person person;
  person.button(1.0, kStop);
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
}

TEST(Stop, AButtonThatTheDeviceLacksIsNamed) {
  Parameters p;
  p.stop_button = 2;
  Person person(p);
  EXPECT_EQ(person.stick(1.0, 0.0F),
            "stop_button = 2, but the message has only buttons 0 to 1: set stop_button to one that the device "
            "has, or to -1 for none");
}

TEST(Stop, PulledBackWithHysteresis) {
  Person person;  // stop_pull 0.8, so a pull goes on down to 0.75 * 0.8 = 0.6
  person.stick(1.0, 0.0F);
  person.stick(1.05, 0.0F, -0.79F);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  person.stick(1.1, 0.0F, -0.8F);
  expect_stopped(person.cycle(1.1));
  person.stick(1.15, 0.0F, -0.61F);
  expect_stopped(person.cycle(1.15));
  person.stick(1.2, 0.0F, -1.0F);
  expect_stopped(person.cycle(1.2));
  person.stick(1.25, 0.0F, -0.59F);
  EXPECT_EQ(person.cycle(1.25).state, State::autonomy);
  person.stick(1.3, 0.0F, -0.7F);  // a new pull begins at 0.8 only
  EXPECT_EQ(person.cycle(1.3).state, State::autonomy);
  person.stick(1.35, 0.0F, 1.0F);  // forward is no pull
  EXPECT_EQ(person.cycle(1.35).state, State::autonomy);
}

TEST(Stop, PulledByTheSignOfTheAxis) {
  Parameters p;
  p.axis_linear.reversed = true;  // down is +1
  Person person(p);
  person.stick(1.0, 0.0F);
  person.stick(1.05, 0.0F, -1.0F);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  person.stick(1.1, 0.0F, 1.0F);
  expect_stopped(person.cycle(1.1));
}

TEST(Stop, PulledWhileSteering) {
  Person person;
  person.steer(1.0);
  person.stick(1.1, 0.6F, -0.8F);
  expect_stopped(person.cycle(1.1));
  person.stick(1.15, 0.5F, 0.0F);
  expect_intent(person.cycle(1.15), State::shared, Influence::shared, 0.5, 0.25);  // 0.5^2
}

TEST(Stop, AStickPulledAtTheStartMustBeSeenOtherwiseOnce) {
  Person person;
  for (const double time : {1.0, 1.05, 2.0}) {
    person.stick(time, 0.0F, -1.0F);
    EXPECT_EQ(person.cycle(time).state, State::autonomy);
  }
  person.stick(2.05, 0.0F, -0.7F);  // below the threshold is otherwise
  EXPECT_EQ(person.cycle(2.05).state, State::autonomy);
  person.stick(2.1, 0.0F, -1.0F);
  expect_stopped(person.cycle(2.1));
}

TEST(Stop, AStickPulledAtTheStartStopsWhereNeutralIsNotRequired) {
  Parameters p;
  p.require_neutral = false;
  Person person(p);
  person.stick(1.0, 0.0F, -1.0F);
  expect_stopped(person.cycle(1.0));
}

TEST(Stop, PullsOnlyWhereTheyAskForNothingElse) {
  const auto state_when_pulled = [](const Parameters& p) {
    Person person(p);
    person.stick(1.0, 0.0F);
    person.stick(1.05, 0.0F, -1.0F);
    return person.cycle(1.05).state;
  };
  Parameters p;
  EXPECT_EQ(state_when_pulled(p), State::stopped);
  p.mode = OperatorMode::gesture;
  EXPECT_EQ(state_when_pulled(p), State::stopped);
  p.mode = OperatorMode::switching;
  EXPECT_EQ(state_when_pulled(p), State::autonomy);
  p = Parameters();
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

TEST(Stop, AnAxisOutOfRangeIsDroppedButAPullAllTheSame) {
  Person person;
  person.stick(1.0, 0.0F);
  EXPECT_EQ(person.stick(1.05, 0.0F, 1.5F),
            "axes[1] = 1.5 is outside [-1, 1]: scale it at the sender, or set axis_linear to another axis");
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  EXPECT_NE(person.stick(1.1, 0.0F, -1.5F), "");
  expect_stopped(person.cycle(1.1));
  EXPECT_EQ(person.machine.dropped(), 2U);
  Parameters p;
  p.stop_pull = 0.0;  // then nobody reads it
  Person other(p);
  EXPECT_EQ(other.stick(1.0, 0.0F, -1.5F), "");
}

TEST(Stop, AStickWithOneAxisCannotBePulled) {
  Person person;
  StickMessage message = stick_at(1.0, 0.0F);
  message.axes = {0.0F};
  EXPECT_EQ(person.machine.receive(message), "");
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
}

TEST(Stop, InWordsForAsLongAsItIsSaid) {
  Person person(with_button());
  person.machine.stop(true);  // no stick is needed
  expect_stopped(person.cycle(1.0));
  person.stick(1.05, 0.0F);  // nor does a stick that lies still take it back
  expect_stopped(person.cycle(1.05));
  expect_stopped(person.cycle(100.0));
  person.machine.stop(false);
  EXPECT_EQ(person.cycle(100.05).state, State::autonomy);
  person.machine.stop(true);
  person.button(100.1, kStop);
  person.machine.stop(false);
  expect_stopped(person.cycle(100.1));  // the button is still held
}

TEST(Stop, SilenceKeepsItWhateverThePolicy) {
  for (const OnInputLost policy : {OnInputLost::hold, OnInputLost::stop, OnInputLost::autonomy}) {
    Parameters p = with_button();
    p.on_input_lost = policy;
    Person person(p);
    person.steer(1.0);
    person.button(1.1, kStop, 1.0F);
    expect_stopped(person.cycle(1.1));
    for (double time = 1.2; time < 20.0; time += 0.1) expect_stopped(person.cycle(time));
    person.button(20.0, kStop);  // the input returns ...
    expect_stopped(person.cycle(20.0));
    person.stick(20.05, 0.0F);  // ... and releases
    expect_intent(person.cycle(20.05), State::autonomy, Influence::none, 0.0, 0.0);
  }
}

TEST(Stop, ALossDuringItOutlivesIt) {
  Parameters p = with_button();
  p.on_input_lost = OnInputLost::stop;
  Person person(p);
  person.steer(1.0);
  person.button(1.1, kStop, 1.0F);
  expect_stopped(person.cycle(1.1));
  expect_stopped(person.cycle(2.0));
  person.stick(3.0, 1.0F);  // released, but the stick was not seen centred
  expect_intent(person.cycle(3.0), State::lost, Influence::stop, 0.0, 0.0);
  person.stick(3.05, 0.0F);
  EXPECT_EQ(person.cycle(3.05).state, State::autonomy);
}

// Whoever stops and lets go of a robot that brakes because its link is cut has not mended the link.
TEST(Stop, InWordsDuringALossDoesNotEndTheLoss) {
  Parameters p;
  p.on_input_lost = OnInputLost::stop;
  Person person(p);
  person.steer(1.0);
  expect_intent(person.cycle(1.6), State::lost, Influence::stop, 0.0, 0.0);
  person.machine.stop(true);
  expect_stopped(person.cycle(1.65));
  person.machine.stop(false);
  expect_intent(person.cycle(1.7), State::lost, Influence::stop, 0.0, 0.0);
}

TEST(Stop, DuringALossEndsItsHold) {
  Person person;
  person.steer(1.0);
  expect_intent(person.cycle(1.6), State::lost, Influence::shared, 0.5, 0.0);
  person.machine.stop(true);
  expect_stopped(person.cycle(1.65));
  person.machine.stop(false);
  expect_intent(person.cycle(1.7), State::lost, Influence::none, 0.0, 0.0);
}

TEST(Stop, ABadMessageDoesNotEndIt) {
  Person person(with_button());
  person.button(1.0, kStop);
  expect_stopped(person.cycle(1.0));
  EXPECT_NE(person.stick(1.05, std::numeric_limits<float>::quiet_NaN()), "");
  expect_stopped(person.cycle(1.05));
}

TEST(Stop, OutlivesAChangeOfMode) {
  Person person(with_button());
  person.button(1.0, kStop);
  expect_stopped(person.cycle(1.0));
  person.p.mode = OperatorMode::switching;
  person.machine.configure(person.p);
  expect_stopped(person.cycle(1.05));
  // Nobody listens to the device any more, and whoever changed the mode let go of it.
  person.p.mode = OperatorMode::off;
  person.machine.configure(person.p);
  expect_stopped(person.cycle(1.1));
  expect_stopped(person.cycle(1.95));
  expect_intent(person.cycle(2.05), State::autonomy, Influence::none, 0.0, 0.0);  // 1 s after the device's last message
  EXPECT_NE(person.machine.take_warnings().find("has ended"), std::string::npos);
}

TEST(Stop, InWordsCountsWhereNobodyMaySteer) {
  Person person;
  person.p.mode = OperatorMode::off;
  person.machine.configure(person.p);
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
  person.machine.stop(true);
  expect_stopped(person.cycle(1.05));
  expect_stopped(person.cycle(9.0));
  person.machine.stop(false);
  EXPECT_EQ(person.cycle(9.05).state, State::autonomy);
}

TEST(Stop, InWordsOutlivesAChangeToOff) {
  Person person;
  person.steer(1.0);
  person.machine.stop(true);
  expect_stopped(person.cycle(1.05));
  person.p.mode = OperatorMode::off;
  person.machine.configure(person.p);
  expect_stopped(person.cycle(9.0));
  person.p.mode = OperatorMode::joystick;
  person.machine.configure(person.p);
  expect_stopped(person.cycle(9.05));
  person.machine.stop(false);
  EXPECT_EQ(person.cycle(9.1).state, State::autonomy);
}

TEST(Stop, APullGoesOnWhereAnotherButtonIsChosen) {
  Person person;
  person.stick(1.0, 0.0F);
  person.stick(1.05, 0.0F, -1.0F);
  expect_stopped(person.cycle(1.05));
  person.p.stop_button = static_cast<int>(kStop);
  person.machine.configure(person.p);
  person.stick(1.1, 0.0F, -1.0F);
  expect_stopped(person.cycle(1.1));
  person.stick(1.15, 0.0F);
  EXPECT_EQ(person.cycle(1.15).state, State::autonomy);
}

TEST(Stop, AnotherDeviceThatLiesPulledDoesNotStop) {
  Person person;
  person.stick(1.0, 0.0F);
  person.cycle(1.0);
  StickMessage other = stick_at(1.05, 0.0F, -1.0F);
  other.sender = "/another_joy_node";
  person.machine.receive(other);
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  other.received = 1.1;
  other.axes[1] = 0.0F;
  person.machine.receive(other);
  other.received = 1.15;
  other.axes[1] = -1.0F;
  person.machine.receive(other);
  expect_stopped(person.cycle(1.15));
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

StickMessage from(const std::string& sender, double time, bool stop) {
  StickMessage message = stick_at(time, 0.0F);
  message.sender = sender;
  message.buttons[kStop] = stop ? 1 : 0;
  return message;
}

// Whatever else the message holds: what is wrong with it drops its steering, not its stop.
TEST(Stop, FromAMessageThatIsFaultyElsewhere) {
  const auto stops = [](const auto& spoil) {
    Person person(with_button());
    person.stick(1.0, 0.0F);
    EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
    StickMessage message = stick_at(1.05, 0.0F);
    spoil(message);
    EXPECT_NE(person.machine.receive(message), "");
    EXPECT_EQ(person.machine.dropped(), 1U);
    const bool stopped = person.cycle(1.05).state == State::stopped;
    person.stick(1.1, 0.0F);  // one in order lets go
    EXPECT_EQ(person.cycle(1.1).state, State::autonomy);
    return stopped;
  };
  const auto press = [](StickMessage& m) { m.buttons[kStop] = 1; };
  const auto pull = [](StickMessage& m) { m.axes[1] = -1.0F; };
  EXPECT_TRUE(stops([&](StickMessage& m) { press(m), m.axes[0] = kNan; }));
  EXPECT_TRUE(stops([&](StickMessage& m) { press(m), m.axes[1] = kNan; }));
  EXPECT_TRUE(stops([&](StickMessage& m) { press(m), m.axes[0] = 1.2F; }));
  EXPECT_TRUE(stops([&](StickMessage& m) { press(m), m.axes.clear(); }));
  EXPECT_TRUE(stops([&](StickMessage& m) { press(m), m.stamp = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_TRUE(stops([&](StickMessage& m) { m.buttons[kStop] = 2; }));
  EXPECT_TRUE(stops([&](StickMessage& m) { pull(m), m.axes[0] = kNan; }));
  EXPECT_TRUE(stops([&](StickMessage& m) { pull(m), m.buttons.clear(); }));
  EXPECT_TRUE(stops([&](StickMessage& m) { m.axes[1] = -1.2F; }));
  // Nothing of these is a stop.
  EXPECT_FALSE(stops([&](StickMessage& m) { m.axes[1] = kNan; }));
  EXPECT_FALSE(stops([&](StickMessage& m) { m.axes[1] = std::numeric_limits<float>::infinity(); }));
  EXPECT_FALSE(stops([&](StickMessage& m) { m.buttons.clear(); }));
}

TEST(Stop, GoesOnWhileOnlyFaultyMessagesTakeItBack) {
  Person person(with_button());
  person.stick(1.0, 0.0F);
  person.button(1.05, kStop, kNan);
  for (double time = 1.1; time < 5.0; time += 0.05) {
    person.stick(time, kNan);  // the button is up, but who knows
    expect_stopped(person.cycle(time));
  }
  person.stick(5.0, 0.0F);
  EXPECT_EQ(person.cycle(5.0).state, State::autonomy);
}

// A link that became 0.6 s slower for good: the first message with the stop in it counts.
TEST(Stop, FromALateMessageAtOnce) {
  Person person(with_button());
  const auto send = [&](double sent, double received, bool stop) {
    StickMessage message = from("/joy", received, stop);
    message.stamp = sent;
    return person.machine.receive(message);
  };
  for (int i = 0; i < 20; ++i) EXPECT_EQ(send(1.0 + 0.05 * i, 1.0 + 0.05 * i, false), "");
  EXPECT_NE(send(2.0, 2.6, true), "");
  expect_stopped(person.cycle(2.6));
  // Late messages do not let go. After 2 s the link is known to be so slow, and then they are not late any more.
  for (int i = 1; i <= 45; ++i) {
    const bool late = !send(2.0 + 0.05 * i, 2.6 + 0.05 * i, false).empty();
    if (i != 40) {
      EXPECT_EQ(late, i < 40) << i;
    }
    EXPECT_EQ(person.cycle(2.6 + 0.05 * i).state, late ? State::stopped : State::autonomy) << i;
  }
}

TEST(Stop, BesideATwistAndAHandToo) {
  Parameters p = with_button();
  p.twist_topic = "operator_twist";
  Person by_twist(p);
  by_twist.twist(1.0, 0.0, 0.0);
  by_twist.twist(1.05, 0.3, 0.3);
  EXPECT_EQ(by_twist.cycle(1.05).state, State::shared);
  StickMessage message = from("/joy", 1.1, true);
  message.stamp = std::numeric_limits<double>::infinity();
  EXPECT_NE(by_twist.machine.receive(message), "");
  expect_stopped(by_twist.cycle(1.1));
  by_twist.twist(1.15, 0.3, 0.3);  // another sender's message
  expect_stopped(by_twist.cycle(1.15));

  p = with_button();
  p.mode = OperatorMode::gesture;
  p.clutch_axis = {3};  // the device does not have it
  Person by_hand(p);
  by_hand.hand(1.0, 0.0);
  EXPECT_NE(by_hand.machine.receive(from("/joy", 1.05, true)), "");
  expect_stopped(by_hand.cycle(1.05));
  by_hand.hand(1.1, 0.0);
  expect_stopped(by_hand.cycle(1.1));
}

TEST(Stop, EverySenderHasItsOwn) {
  Person person(with_button());
  person.machine.receive(from("/first", 1.0, false));
  person.machine.receive(from("/second", 1.05, true));
  expect_stopped(person.cycle(1.05));
  for (int i = 0; i < 40; ++i) {
    person.machine.receive(from("/first", 1.1 + 0.05 * i, false));
    expect_stopped(person.cycle(1.1 + 0.05 * i));
  }
  person.machine.receive(from("/first", 3.1, true));
  person.machine.receive(from("/second", 3.15, false));
  expect_stopped(person.cycle(3.15));
  person.machine.receive(from("/first", 3.2, false));
  EXPECT_EQ(person.cycle(3.2).state, State::autonomy);
}

// Two that take turns are new devices after each other, and each of them stops at once.
TEST(Stop, ByAPullOfOneOfTwoThatTakeTurns) {
  Person person;
  const auto send = [&](const std::string& sender, double time, float along) {
    StickMessage message = stick_at(time, 0.0F, along);
    message.sender = sender;
    person.machine.receive(message);
    return person.cycle(time).state;
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
  Person person(with_button());
  person.machine.receive(from("/joy_1", 1.0, true));
  expect_stopped(person.cycle(1.0));
  for (double time = 1.05; time < 5.0; time += 0.05) {
    person.machine.receive(from("/joy_2", time, false));  // its successor
    expect_stopped(person.cycle(time));
  }
  EXPECT_NE(person.machine.advice().find("The stop of /joy_1 goes on"), std::string::npos) << person.machine.advice();
  EXPECT_EQ(person.machine.take_warnings(), "");
  person.machine.stop(false);
  EXPECT_EQ(person.cycle(5.0).state, State::autonomy);
  EXPECT_EQ(person.machine.take_warnings(),
            "The stop of /joy_1, which asked for it last 4 s ago, has ended: the topic stop or a change of mode "
            "released it.");
  EXPECT_EQ(person.machine.take_warnings(), "");
  EXPECT_EQ(person.machine.advice().find("/joy_1 goes on"), std::string::npos);
}

// Who still holds the button has not let go, whatever others say; once they fall silent, the words count.
TEST(Stop, OfADeviceThatLivesDoesNotEndInWords) {
  Person person(with_button());
  person.machine.receive(from("/joy", 1.0, true));
  person.machine.stop(false);
  expect_stopped(person.cycle(1.9));
  person.machine.receive(from("/joy", 1.95, true));
  expect_stopped(person.cycle(10.0));
  person.machine.stop(false);
  EXPECT_EQ(person.cycle(10.05).state, State::autonomy);
}

TEST(Stop, OfADeviceThatDiedEndsWithTheMode) {
  Person person(with_button());
  person.machine.receive(from("/joy", 1.0, true));
  expect_stopped(person.cycle(5.0));
  person.p.mode = OperatorMode::switching;
  person.machine.configure(person.p);
  EXPECT_EQ(person.cycle(5.05).state, State::autonomy);
  EXPECT_NE(person.machine.take_warnings().find("/joy"), std::string::npos);
}

TEST(Stop, NamesWithoutNumberDoNotPileUp) {
  Person person(with_button());
  person.machine.receive(from("/holds", 1.0, true));
  Bytes few, many;
  const auto visit = [&](int first, int last) {
    for (int i = first; i < last; ++i)
      person.machine.receive(from("/joy_" + std::to_string(100 + i), 1.0 + 0.01 * i, false));
  };
  visit(0, 100);
  ArchiveWriter write_few(few);
  person.machine.save(write_few);
  visit(100, 800);
  ArchiveWriter write_many(many);
  person.machine.save(write_many);
  EXPECT_EQ(many.size(), few.size());
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
