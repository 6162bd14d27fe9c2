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

void expect_stopped(const OperatorIntent& intent) {
  expect_intent(intent, State::stopped, Influence::stop, 0.0, 0.0);
}

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
  CycleFeedback refused;
  refused.own_command_refused = refused.at_rest = true;
  person.stick(1.0, 0.0F);
  person.stick(1.05, 1.0F);
  person.cycle(1.05, refused);
  EXPECT_EQ(person.cycle(1.1, refused).state, State::blocked);
  person.button(1.15, kStop, 1.0F);
  expect_stopped(person.cycle(1.15, refused));
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
  EXPECT_EQ(
      person.stick(1.0, 0.0F),
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
  p.axis_linear_sign = -1;  // down is +1
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

TEST(Stop, AnAxisThatIsPulledMustBeInRange) {
  Person person;
  person.stick(1.0, 0.0F);
  EXPECT_EQ(person.stick(1.05, 0.0F, -1.5F),
            "axes[1] = -1.5 is outside [-1, 1]: scale it at the sender, or set axis_linear to another axis");
  EXPECT_EQ(person.cycle(1.05).state, State::autonomy);
  EXPECT_EQ(person.machine.dropped(), 1U);
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
  person.p.mode = OperatorMode::off;  // nobody steers: nobody stops
  person.machine.configure(person.p);
  expect_intent(person.cycle(1.1), State::autonomy, Influence::none, 0.0, 0.0);
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

TEST(Stop, TimeThatJumpsBackForgetsTheButton) {
  Parameters p = with_button();
  p.twist_topic = "operator_twist";
  Person person(p);
  person.button(100.0, kStop);
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
}

}  // namespace
}  // namespace hidwa_local_planner::input
