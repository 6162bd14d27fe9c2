// SPDX-License-Identifier: BSD-3-Clause
// Mode gesture: a tracked hand with a clutch.
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

using State = OperatorStateId;
constexpr std::size_t kClutch = 0;

Parameters by_hand() {
  Parameters p;  // gesture_axis y, gesture_range 0.3 m, clutch_button 0
  p.mode = OperatorMode::gesture;
  return p;
}

/// Clutch released at `time`, pressed 0.05 s later with the hand at y = 0.
void engage(Person& person, double time) {
  person.stick(time, 0.0F);
  person.hand(time, 0.0);
  person.cycle(time);
  person.button(time + 0.05, kClutch);
  person.hand(time + 0.05, 0.0);
  EXPECT_EQ(person.cycle(time + 0.05).state, State::autonomy);
}

/// The clutch still held and the hand at `y`; then a cycle.
OperatorIntent move(Person& person, double time, double y) {
  person.button(time, kClutch);
  person.hand(time, y);
  return person.cycle(time);
}

/// Engaged at 1.05, steering to the left from 1.1 on: y = 0.15, omega = (0.15 / 0.3)^2 = 0.25.
void steer(Person& person) {
  engage(person, 1.0);
  const OperatorIntent intent = move(person, 1.1, 0.15);
  EXPECT_EQ(intent.state, State::shared);
  EXPECT_NEAR(intent.u_h.omega, 0.25, 1e-6);
}

/// The command for a hand displaced by `moved`.
OperatorCommand command_of_hand(const Parameters& p, const Eigen::Vector3d& moved) {
  GestureSource source;
  source.configure(p, true);
  Buttons held;
  held.clutch = true;
  source.take_buttons(Buttons(), 1.0);
  source.take_buttons(held, 1.0);
  EXPECT_EQ(source.take(hand_at(1.0, 4.0, -5.0, 6.0), 1.0).fault, "");  // the origin may be anywhere
  for (int k = 1; k <= 20; ++k) {                                       // a jump would be none of a hand
    HandMessage message = hand_at(1.0 + 0.05 * k, 4.0, -5.0, 6.0);
    message.position += 0.05 * k * moved;
    EXPECT_EQ(source.take(message, 1.0 + 0.05 * k).fault, "");
  }
  EXPECT_TRUE(source.engaged());
  return source.command();
}

// Held all along, the clutch engages nothing after a loss: the origin is forgotten with it.
TEST(Gesture, AHandThatIsLostIsNoLongerEngaged) {
  GestureSource source;
  source.configure(by_hand(), true);
  Buttons held;
  held.clutch = true;
  source.take_buttons(Buttons(), 1.0);
  source.take_buttons(held, 1.0);
  source.take(hand_at(1.0, 0.0, 0.1, 0.0), 1.0);
  ASSERT_TRUE(source.engaged());
  source.lose();
  EXPECT_FALSE(source.engaged());
  EXPECT_FALSE(source.command().active);
}

TEST(Gesture, DisplacementThroughTheMap) {
  const Parameters p = by_hand();
  EXPECT_FALSE(command_of_hand(p, {0.0, 0.0, 0.0}).active);
  EXPECT_FALSE(command_of_hand(p, {0.0, 0.0299, 0.0}).active);  // 0.0299 / 0.3 = 0.0997 <= 0.1
  EXPECT_FALSE(command_of_hand(p, {0.0, -0.0299, 0.0}).active);
  const OperatorCommand least = command_of_hand(p, {0.0, 0.0303, 0.0});
  EXPECT_TRUE(least.active);
  EXPECT_NEAR(least.u_h.omega, 0.010201, 1e-7);                             // (0.0303 / 0.3)^2 = 0.101^2
  EXPECT_DOUBLE_EQ(least.u_h.v, 0.5);                                       // v_max
  EXPECT_NEAR(command_of_hand(p, {0.0, 0.15, 0.0}).u_h.omega, 0.25, 1e-6);  // 0.5^2
  EXPECT_NEAR(command_of_hand(p, {0.0, -0.15, 0.0}).u_h.omega, -0.25, 1e-6);
  EXPECT_NEAR(command_of_hand(p, {0.0, 0.3, 0.0}).u_h.omega, 1.0, 1e-6);  // full scale
  EXPECT_DOUBLE_EQ(command_of_hand(p, {0.0, 0.4, 0.0}).u_h.omega, 1.0);   // and clipped
  EXPECT_DOUBLE_EQ(command_of_hand(p, {0.0, -5.0, 0.0}).u_h.omega, -1.0);
  EXPECT_FALSE(command_of_hand(p, {0.3, 0.0, -0.3}).active);  // the other axes do not count
}

TEST(Gesture, RangeAndMaximum) {
  Parameters p = by_hand();
  p.gesture_range = 0.6;
  p.max_vel_theta = 2.0;
  EXPECT_NEAR(command_of_hand(p, {0.0, 0.3, 0.0}).u_h.omega, 0.5, 1e-6);  // (0.3 / 0.6)^2 * 2
}

TEST(Gesture, EachAxisAndSign) {
  const HandAxis axes[2][3] = {{HandAxis::x, HandAxis::y, HandAxis::z},
                               {HandAxis::minus_x, HandAxis::minus_y, HandAxis::minus_z}};
  for (int i = 0; i < 3; ++i) {
    for (const int sign : {1, -1}) {
      Parameters p = by_hand();
      p.gesture_axis = axes[sign < 0][i];
      Eigen::Vector3d moved = Eigen::Vector3d::Zero();
      moved[i] = 0.15;
      EXPECT_NEAR(command_of_hand(p, moved).u_h.omega, 0.25 * sign, 1e-6);  // (0.15 / 0.3)^2
      p.linear = LinearPolicy::axis;
      p.gesture_linear_axis = axes[sign < 0][i];
      p.gesture_axis = axes[0][(i + 1) % 3];
      const OperatorCommand command = command_of_hand(p, moved);
      EXPECT_TRUE(command.active);
      EXPECT_NEAR(command.u_h.v, 0.125 * sign, 1e-6);  // (0.15 / 0.3)^2 * 0.5 m/s
      EXPECT_DOUBLE_EQ(command.u_h.omega, 0.0);
    }
  }
}

TEST(Gesture, SharedWhileTheHandIsAwayFromItsOrigin) {
  Person person(by_hand());
  steer(person);
  const OperatorIntent right = move(person, 1.15, -0.14);
  EXPECT_EQ(right.state, State::shared);
  EXPECT_EQ(right.influence, Influence::shared);
  EXPECT_DOUBLE_EQ(right.u_h.v, 0.5);
  EXPECT_NEAR(right.u_h.omega, -0.217778, 1e-6);  // -(0.14 / 0.3)^2
  EXPECT_EQ(move(person, 1.2, 0.01).state, State::hold);
  EXPECT_EQ(move(person, 1.25, 0.15).state, State::shared);
}

TEST(Gesture, LettingGoIsHeardAtOnceAndIsARelease) {
  Person person(by_hand());
  steer(person);
  person.stick(1.13, 0.0F);  // no pose since
  expect_intent(person.cycle(1.15), State::hold, Influence::shared, 0.5, 0.0);
  person.hand(1.2, 0.3);                             // without the clutch
  EXPECT_EQ(person.cycle(3.09).state, State::hold);  // 3.09 - 1.1 = 1.99 < delta
  EXPECT_EQ(person.cycle(3.11).state, State::autonomy);
}

TEST(Gesture, PressingAgainElsewhereMakesANewOrigin) {
  Person person(by_hand());
  steer(person);
  person.stick(1.15, 0.0F);
  person.hand(1.15, 7.0);  // it may jump while nobody holds the clutch
  EXPECT_EQ(person.cycle(1.15).state, State::hold);
  EXPECT_EQ(move(person, 1.2, 7.0).state, State::hold);  // the new origin
  const OperatorIntent intent = move(person, 1.25, 6.85);
  EXPECT_EQ(intent.state, State::shared);
  EXPECT_NEAR(intent.u_h.omega, -0.25, 1e-6);  // (6.85 - 7) / 0.3 = -0.5
}

TEST(Gesture, TheFirstPoseAfterThePressIsTheOrigin) {
  Person person(by_hand());
  person.stick(1.0, 0.0F);
  person.cycle(1.0);
  person.button(1.05, kClutch);  // tracking has not begun
  person.cycle(1.05);
  EXPECT_EQ(move(person, 1.1, 3.0).state, State::autonomy);
  EXPECT_NEAR(move(person, 1.15, 3.15).u_h.omega, 0.25, 1e-6);
}

TEST(Gesture, AClutchHeldAtTheStartMustBeLetGo) {
  Person person(by_hand());
  for (const double time : {1.0, 1.05, 1.1}) EXPECT_EQ(move(person, time, 3.0 * (time - 1.0)).state, State::autonomy);
  EXPECT_NE(person.machine.advice().find("clutch"), std::string::npos);
  steer(person);
  EXPECT_EQ(person.machine.advice(), "");
}

TEST(Gesture, AClutchHeldAtTheStartMustBeLetGoWithoutNeutralToo) {
  Parameters p = by_hand();
  p.require_neutral = false;
  Person person(p);
  for (const double time : {1.0, 1.05, 1.1}) EXPECT_EQ(move(person, time, 3.0 * (time - 1.0)).state, State::autonomy);
  steer(person);
}

TEST(Gesture, AnAxisMayBeTheClutch) {
  Parameters p = by_hand();
  p.clutch_axis = {1, true};  // a trigger that rests at +1 and goes to -1
  p.stop_pull = 0.0;
  Person person(p);
  const auto at = [&person](double time, float trigger, double y) {
    person.stick(time, 0.0F, trigger);
    person.hand(time, y);
    return person.cycle(time).state;
  };
  EXPECT_EQ(at(1.0, 1.0F, 0.0), State::autonomy);
  EXPECT_EQ(at(1.05, -0.5F, 0.0), State::autonomy);  // at the threshold is not beyond it
  EXPECT_EQ(at(1.1, -0.5F, 0.15), State::autonomy);
  EXPECT_EQ(at(1.15, -0.51F, 0.0), State::autonomy);
  EXPECT_EQ(at(1.2, -0.51F, 0.15), State::shared);
  EXPECT_EQ(at(1.25, 0.0F, 0.15), State::hold);
}

TEST(Gesture, TheStickSteersNothing) {
  Person person(by_hand());
  person.steer(1.0);
  EXPECT_EQ(person.cycle(1.1).state, State::autonomy);
  EXPECT_EQ(person.machine.dropped(), 0U);
}

TEST(Gesture, AClutchThatTheDeviceLacksIsNamedWithTheRemedy) {
  Parameters p = by_hand();
  p.clutch_button = 5;
  EXPECT_EQ(Person(p).stick(1.0, 0.0F),
            "clutch_button = 5, but the message has only buttons 0 to 1: set clutch_button to one that the device "
            "has, or to -1 for none");
  p.clutch_axis = {6};
  EXPECT_EQ(Person(p).stick(1.0, 0.0F),
            "clutch_axis = 6, but the message has only axes 0 to 1: set clutch_axis to one that the device has");
  p.clutch_axis = {1};
  p.stop_pull = 0.0;
  EXPECT_EQ(Person(p).stick(1.0, 0.0F, -2.0F),
            "axes[1] = -2 is outside [-1, 1]: scale it at the sender, or set clutch_axis to another axis");
}

/// What a tracker sends when it has lost the hand, each with the fault that is told.
struct Untracked {
  HandMessage message;
  const char* fault;
};

std::vector<Untracked> untracked(double time) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  HandMessage no_number = hand_at(time, 1.0, nan, 1.0);
  HandMessage no_rotation = hand_at(time, 1.0, 0.15, 1.0);
  no_rotation.orientation[3] = nan;
  HandMessage zero_quaternion = hand_at(time, 1.0, 0.15, 1.0);
  zero_quaternion.orientation.setZero();
  HandMessage identity = hand_at(time, 0.0, 0.0, 0.0);
  identity.orientation = {0.0, 0.0, 0.0, 1.0};
  return {{no_number, "not a finite number"},
          {no_rotation, "not a finite number"},
          {zero_quaternion, "orientation is all zero"},
          {identity, "the identity"},
          {hand_at(time, 1.0, 0.46, 1.0), "jumped by 0.31 m"}};  // from 0.15
}

TEST(Gesture, LostTrackingIsLostInputUntilTheClutchIsLetGo) {
  for (const Untracked& bad : untracked(1.15)) {
    Person person(by_hand());
    steer(person);
    const std::string fault = person.machine.receive(bad.message);
    EXPECT_NE(fault.find(bad.fault), std::string::npos) << fault;
    EXPECT_EQ(person.machine.dropped(), 1U);
    expect_intent(person.cycle(1.15), State::lost, Influence::shared, 0.5,
                  0.0);              // as a release: delta from 1.1
    for (int i = 0; i < 100; ++i) {  // tracking is back, but the clutch is still held
      const OperatorIntent intent = move(person, 1.2 + 0.05 * i, 0.15);
      ASSERT_EQ(intent.state, State::lost);
      ASSERT_DOUBLE_EQ(intent.u_h.omega, 0.0);
    }
    EXPECT_NE(person.machine.advice().find("release its clutch"), std::string::npos);
    person.stick(6.2, 0.0F);
    EXPECT_EQ(person.cycle(6.2).state, State::autonomy);
    person.hand(6.25, 0.15);
    EXPECT_EQ(move(person, 6.25, 0.15).state, State::autonomy);
    EXPECT_EQ(move(person, 6.3, 0.3).state, State::shared);
  }
}

TEST(Gesture, LostTrackingByPolicy) {
  for (const OnInputLost policy : {OnInputLost::stop, OnInputLost::autonomy}) {
    for (const Untracked& bad : untracked(1.15)) {
      Parameters p = by_hand();
      p.on_input_lost = policy;
      Person person(p);
      steer(person);
      EXPECT_NE(person.machine.receive(bad.message), "");
      const Influence wanted = policy == OnInputLost::stop ? Influence::stop : Influence::none;
      expect_intent(person.cycle(1.15), State::lost, wanted, 0.0, 0.0);
      EXPECT_EQ(move(person, 1.2, 0.15).influence, wanted);
    }
  }
}

TEST(Gesture, AHandMayMoveAsFastAsTheJumpAllows) {
  Person person(by_hand());
  steer(person);
  const OperatorIntent intent = move(person, 1.15, -0.149);  // 0.299 m from 0.15
  EXPECT_EQ(intent.state, State::shared);
  EXPECT_LT(intent.u_h.omega, 0.0);
}

TEST(Gesture, LostTrackingWithoutTheClutchLosesNothing) {
  Person person(by_hand());
  person.stick(1.0, 0.0F);
  for (const Untracked& bad : untracked(1.0)) person.machine.receive(bad.message);
  EXPECT_EQ(person.machine.dropped(), 4U);  // a jump is none without an origin
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
  engage(person, 1.05);
  EXPECT_EQ(move(person, 1.15, 0.15).state, State::shared);
}

TEST(Gesture, LostTrackingJustBeforeThePressIsNoLossEither) {
  Person person(by_hand());
  person.stick(1.0, 0.0F);
  person.cycle(1.0);
  person.machine.receive(untracked(1.02).front().message);
  EXPECT_EQ(move(person, 1.05, 0.0).state, State::autonomy);
  EXPECT_EQ(move(person, 1.1, 0.15).state, State::shared);
}

// Both messages come from one headset: the stick's must not hide that its tracking is gone.
TEST(Gesture, AnUntrackedHandIsToldWhileTheStickIsHeard) {
  Person person(by_hand());
  HandMessage message = hand_at(1.0, 1.0, 0.0, 1.0);
  message.orientation.setZero();
  person.machine.receive(message);
  person.stick(1.0, 0.0F);
  EXPECT_NE(person.machine.advice().find("not tracked"), std::string::npos);
  person.hand(1.05, 0.0);
  EXPECT_EQ(person.machine.advice(), "");
}

TEST(Gesture, SilentPosesAreALoss) {
  Person person(by_hand());
  steer(person);
  OperatorIntent intent;
  for (int i = 1; i <= 20; ++i) {  // the clutch goes on
    const double now = 1.1 + 0.05 * i;
    person.button(now, kClutch);
    intent = person.cycle(now + 1e-3);
    EXPECT_EQ(intent.state, now < 1.59 ? State::shared : State::lost) << now;  // 0.5 s from 1.1
  }
  EXPECT_DOUBLE_EQ(intent.u_h.omega, 0.0);
  EXPECT_EQ(move(person, 2.2, 0.15).state, State::lost);  // back, but the origin is old
  person.stick(2.25, 0.0F);
  EXPECT_EQ(person.cycle(2.25).state, State::hold);
}

TEST(Gesture, ASilentClutchIsALossWhilePosesGoOn) {
  Person person(by_hand());
  steer(person);
  for (int i = 1; i <= 40; ++i) {
    const double now = 1.1 + 0.05 * i;
    person.hand(now, 0.15);
    EXPECT_EQ(person.cycle(now + 1e-3).state, now < 1.59 ? State::shared : State::lost) << now;
  }
}

// What nobody follows any more must not steer from where it once was.
TEST(Gesture, SilenceAtTheOriginMakesTheOriginOld) {
  Person person(by_hand());
  engage(person, 1.0);  // held, and not away from the origin: no input, nothing to lose
  for (int i = 0; i < 40; ++i) {
    person.button(1.1 + 0.05 * i, kClutch);
    EXPECT_EQ(person.cycle(1.1 + 0.05 * i).state, State::autonomy);
  }
  EXPECT_EQ(move(person, 3.2, 0.25).state, State::autonomy);
  EXPECT_EQ(move(person, 3.25, 0.25).state, State::autonomy);
  EXPECT_NE(person.machine.advice().find("clutch"), std::string::npos);
}

TEST(Gesture, ASilenceThatNoCycleSawMakesTheOriginOldToo) {
  Parameters p = by_hand();
  p.require_neutral = false;
  Person person(p);
  steer(person);
  person.button(9.0, kClutch);
  person.hand(9.0, 0.25);
  EXPECT_EQ(person.cycle(9.0).state, State::lost);
  EXPECT_EQ(move(person, 9.05, 0.25).state, State::lost);
}

TEST(Gesture, AnotherSenderOfPosesMakesANewOrigin) {
  Person person(by_hand());
  steer(person);
  HandMessage other = hand_at(1.15, 1.0, 0.2, 1.0);
  other.sender = "/another_tracker";
  person.machine.receive(other);
  EXPECT_EQ(person.cycle(1.15).state, State::hold);
  other.received = 1.2;
  other.position[1] = 0.3;
  person.machine.receive(other);
  EXPECT_EQ(person.cycle(1.2).state, State::hold);  // the clutch was not let go
  // Nor does it steer by way of the old origin.
  for (const double y : {0.0, 0.15}) {
    other.received += 0.05;
    other.position[1] = y;
    person.machine.receive(other);
    EXPECT_EQ(person.cycle(other.received).state, State::hold);
  }
}

TEST(Gesture, TheRangeChangesWhileSteering) {
  Person person(by_hand());
  steer(person);
  person.p.gesture_range = 0.6;
  person.machine.configure(person.p);
  EXPECT_NEAR(person.cycle(1.15).u_h.omega, 0.0625, 1e-6);  // (0.15 / 0.6)^2
}

TEST(Gesture, AnotherAxisNeedsTheClutchAnew) {
  Person person(by_hand());
  steer(person);
  person.p.gesture_axis = HandAxis::x;
  person.machine.configure(person.p);
  EXPECT_EQ(move(person, 1.15, 0.15).state, State::hold);
  EXPECT_EQ(move(person, 1.2, 0.0).state, State::hold);
}

TEST(Gesture, AGoalLatchAndANewGoal) {
  CycleFeedback latched;
  latched.goal_latched = true;
  Person person(by_hand());
  steer(person);
  person.cycle(1.11, latched);
  EXPECT_EQ(move(person, 1.15, 0.15).state, State::autonomy);
  person.machine.new_goal();
  EXPECT_EQ(move(person, 1.2, 0.15).state,
            State::shared);  // the clutch is still held, the origin is the same
  person.machine.new_goal();
  EXPECT_EQ(move(person, 1.25, 0.15).state, State::shared);
}

TEST(Gesture, IsNotHeardInOtherModes) {
  Person person;
  EXPECT_EQ(person.hand(1.0, std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(person.machine.dropped(), 0U);
}

}  // namespace
}  // namespace hidwa_local_planner::input
