// SPDX-License-Identifier: BSD-3-Clause
// Mode gesture: a tracked hand with a clutch.
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

Parameters by_hand() { return in_mode(OperatorMode::gesture); }  // gesture_axis y, gesture_range 0.3 m

/// A person with a hand, whose clutch is a button.
struct Hand : Person {
  explicit Hand(const Parameters& parameters = by_hand()) : Person(parameters) {}

  /// The clutch held and the hand at `y`; then a cycle.
  OperatorIntent move(double time, double y) {
    button(time, kClutch);
    hand(time, y);
    return cycle(time);
  }
  /// Clutch pressed at 1.05 with the hand at y = 0, to the left from 1.1 on: y = 0.15, omega = (0.15 / 0.3)^2 = 0.25.
  void steer_left() {
    stick(1.0, 0.0F);
    cycle_with(hand_at(1.0, 1.0, 0.0, 1.0));
    EXPECT_EQ(move(1.05, 0.0).state, State::autonomy);
    const OperatorIntent intent = move(1.1, 0.15);
    EXPECT_EQ(intent.state, State::shared);
    EXPECT_NEAR(intent.u_h.omega, 0.25, 1e-6);
  }
};

/// A source with the clutch held and its origin at `position`.
struct EngagedSource : GestureSource {
  EngagedSource(const Parameters& p, const Eigen::Vector3d& position) {
    configure(p, true);
    take_buttons({false, false}, 1.0);
    take_buttons({false, true}, 1.0);
    EXPECT_EQ(take(hand_at(1.0, position.x(), position.y(), position.z()), 1.0).fault, "");
    EXPECT_TRUE(engaged());
  }
};

/// The command for a hand displaced by `moved`.
OperatorCommand command_of_hand(const Parameters& p, const Eigen::Vector3d& moved) {
  EngagedSource source(p, {4.0, -5.0, 6.0});  // the origin may be anywhere
  for (int k = 1; k <= 20; ++k) {             // a jump would be none of a hand
    HandMessage message = hand_at(1.0 + 0.05 * k, 4.0, -5.0, 6.0);
    message.position += 0.05 * k * moved;
    EXPECT_EQ(source.take(message, 1.0 + 0.05 * k).fault, "");
  }
  return source.command();
}

// Held all along, the clutch engages nothing after a loss: the origin is forgotten with it.
TEST(Gesture, AHandThatIsLostIsNoLongerEngaged) {
  EngagedSource source(by_hand(), {0.0, 0.1, 0.0});
  source.lose();
  EXPECT_FALSE(source.engaged());
  EXPECT_FALSE(source.command().active);
}

TEST(Gesture, DisplacementThroughTheMap) {
  struct Row {
    Eigen::Vector3d moved;  // [m]
    double omega;           // [rad/s]; 0: no command
  };
  const Row rows[] = {
      {{0.0, 0.0, 0.0}, 0.0},          // at the origin
      {{0.0, 0.0299, 0.0}, 0.0},       // 0.0299 / 0.3 = 0.0997 <= 0.1
      {{0.0, -0.0299, 0.0}, 0.0},      // to the right, too
      {{0.0, 0.0303, 0.0}, 0.010201},  // (0.0303 / 0.3)^2 = 0.101^2
      {{0.0, 0.15, 0.0}, 0.25},        // 0.5^2
      {{0.0, -0.15, 0.0}, -0.25},      // -(0.5^2)
      {{0.0, 0.3, 0.0}, 1.0},          // full scale
      {{0.0, 0.4, 0.0}, 1.0},          // and clipped
      {{0.0, -5.0, 0.0}, -1.0},        // to the right, too
      {{0.3, 0.0, -0.3}, 0.0},         // the other axes do not count
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.moved.transpose());
    const OperatorCommand command = command_of_hand(by_hand(), row.moved);
    EXPECT_EQ(command.active, row.omega != 0.0);
    if (!command.active) continue;
    EXPECT_NEAR(command.u_h.omega, row.omega, 1e-6);
    EXPECT_DOUBLE_EQ(command.u_h.v, 0.5);  // v_max
  }
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

// From 0.15 m to -0.149 m is as far as a hand gets between two poses.
TEST(Gesture, SharedWhileTheHandIsAwayFromItsOrigin) {
  Hand person;
  person.steer_left();
  const OperatorIntent right = person.move(1.15, -0.149);
  EXPECT_EQ(right.state, State::shared);
  EXPECT_EQ(right.influence, Influence::shared);
  EXPECT_DOUBLE_EQ(right.u_h.v, 0.5);
  EXPECT_NEAR(right.u_h.omega, -0.246678, 1e-6);  // -(0.149 / 0.3)^2
  EXPECT_EQ(person.move(1.2, 0.01).state, State::hold);
  EXPECT_EQ(person.move(1.25, 0.15).state, State::shared);
}

TEST(Gesture, LettingGoIsHeardAtOnceAndIsARelease) {
  Hand person;
  person.steer_left();
  person.stick(1.13, 0.0F);  // no pose since
  expect_hold(person.cycle(1.15), 0.5);
  person.hand(1.2, 0.3);                             // without the clutch
  EXPECT_EQ(person.cycle(3.09).state, State::hold);  // 3.09 - 1.1 = 1.99 < delta
  EXPECT_EQ(person.cycle(3.11).state, State::autonomy);
}

TEST(Gesture, AClutchHeldAtTheStartMustBeLetGoEvenWithoutNeutral) {
  for (const bool require_neutral : {true, false}) {
    Parameters p = by_hand();
    p.require_neutral = require_neutral;
    Hand person(p);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(person.move(0.8 + 0.05 * i, 0.15 * i).state, State::autonomy);
    EXPECT_TRUE(says(person.machine.advice(), "clutch"));
    person.steer_left();
    EXPECT_EQ(person.machine.advice(), "");
  }
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
  Hand person;
  EXPECT_EQ(person.steer(1.0).state, State::autonomy);
  EXPECT_EQ(person.machine.dropped(), 0U);
}

/// What a tracker sends when it has lost the hand, each with the fault that is told.
struct Untracked {
  const char* fault;
  HandMessage message;
};

std::vector<Untracked> untracked(double time) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  HandMessage no_rotation = hand_at(time, 1.0, 0.15, 1.0);
  no_rotation.orientation[3] = nan;
  HandMessage zero_quaternion = hand_at(time, 1.0, 0.15, 1.0);
  zero_quaternion.orientation.setZero();
  HandMessage identity = hand_at(time, 0.0, 0.0, 0.0);
  identity.orientation = {0.0, 0.0, 0.0, 1.0};
  return {{"not a finite number", hand_at(time, 1.0, nan, 1.0)},
          {"not a finite number", no_rotation},
          {"orientation is all zero", zero_quaternion},
          {"the identity", identity},
          {"jumped by 0.31 m", hand_at(time, 1.0, 0.46, 1.0)}};  // from 0.15
}

TEST(Gesture, LostTrackingIsLostInputUntilTheClutchIsLetGo) {
  for (const Untracked& bad : untracked(1.15)) {
    SCOPED_TRACE(bad.fault);
    Hand person;
    person.steer_left();
    EXPECT_TRUE(says(person.machine.receive(bad.message), bad.fault));
    EXPECT_EQ(person.machine.dropped(), 1U);
    // As a release: delta from 1.1.
    expect_intent(person.cycle(1.15), State::lost, Influence::shared, 0.5, 0.0);
    for (int i = 0; i < 100; ++i) {  // tracking is back, but the clutch is still held
      const OperatorIntent intent = person.move(1.2 + 0.05 * i, 0.15);
      ASSERT_EQ(intent.state, State::lost);
      ASSERT_DOUBLE_EQ(intent.u_h.omega, 0.0);
    }
    EXPECT_TRUE(says(person.machine.advice(), "release its clutch"));
    EXPECT_EQ(person.cycle_with_stick(6.2, 0.0F).state, State::autonomy);
    EXPECT_EQ(person.move(6.25, 0.15).state, State::autonomy);
    EXPECT_EQ(person.move(6.3, 0.3).state, State::shared);
  }
}

TEST(Gesture, LostTrackingWithoutTheClutchLosesNothing) {
  Hand person;
  person.stick(1.0, 0.0F);
  for (const Untracked& bad : untracked(1.0)) person.machine.receive(bad.message);
  EXPECT_EQ(person.machine.dropped(), 4U);  // a jump is none without an origin
  EXPECT_EQ(person.cycle(1.0).state, State::autonomy);
  person.machine.receive(untracked(1.02).front().message);  // just before the press
  EXPECT_EQ(person.move(1.05, 0.0).state, State::autonomy);
  EXPECT_EQ(person.move(1.1, 0.15).state, State::shared);
}

// Both messages come from one headset: the stick's must not hide that its tracking is gone.
TEST(Gesture, AnUntrackedHandIsToldWhileTheStickIsHeard) {
  Hand person;
  HandMessage message = hand_at(1.0, 1.0, 0.0, 1.0);
  message.orientation.setZero();
  person.machine.receive(message);
  person.stick(1.0, 0.0F);
  EXPECT_TRUE(says(person.machine.advice(), "not tracked"));
  person.hand(1.05, 0.0);
  EXPECT_EQ(person.machine.advice(), "");
}

TEST(Gesture, ASilenceThatNoCycleSawMakesTheOriginOldToo) {
  Parameters p = by_hand();
  p.require_neutral = false;
  Hand person(p);
  person.steer_left();
  EXPECT_EQ(person.move(9.0, 0.25).state, State::lost);
  EXPECT_EQ(person.move(9.05, 0.25).state, State::lost);
}

TEST(Gesture, WithoutATimeoutASilentHandSteersOn) {
  Parameters p = by_hand();
  p.input_timeout = 0.0;
  Hand person(p);
  person.steer_left();
  EXPECT_EQ(person.cycle(60.0).state, State::shared);
}

// The clutch was not let go. Nor does the other hand steer by way of the old origin.
TEST(Gesture, AnotherSenderOfPosesMakesANewOrigin) {
  Hand person;
  person.steer_left();
  double time = 1.1;
  for (const double y : {0.2, 0.3, 0.0, 0.15}) {
    time += 0.05;
    EXPECT_EQ(person.cycle_with(from("/another_tracker", hand_at(time, 1.0, y, 1.0))).state, State::hold) << y;
  }
}

TEST(Gesture, TheRangeChangesWhileSteering) {
  Hand person;
  person.steer_left();
  person.p.gesture_range = 0.6;
  person.configure();
  EXPECT_NEAR(person.cycle(1.15).u_h.omega, 0.0625, 1e-6);  // (0.15 / 0.6)^2
}

TEST(Gesture, AnotherAxisNeedsTheClutchAnew) {
  Hand person;
  person.steer_left();
  person.p.gesture_axis = HandAxis::minus_y;
  person.configure();
  EXPECT_EQ(person.move(1.15, 0.15).state, State::hold);
  EXPECT_EQ(person.move(1.2, 0.0).state, State::hold);
}

TEST(Gesture, AGoalLatchAndANewGoal) {
  Hand person;
  person.steer_left();
  person.cycle(1.11, at_goal());
  EXPECT_EQ(person.move(1.15, 0.15).state, State::autonomy);
  for (const double time : {1.2, 1.25}) {
    person.machine.new_goal();
    EXPECT_EQ(person.move(time, 0.15).state, State::shared);  // the clutch is still held, the origin is the same
  }
}

TEST(Gesture, IsNotHeardInOtherModes) {
  Person person;
  EXPECT_EQ(person.hand(1.0, std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(person.machine.dropped(), 0U);
}

}  // namespace
}  // namespace hidwa_local_planner::input
