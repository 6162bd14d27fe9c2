// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include <gtest/gtest.h>

#include "person.hpp"

namespace hidwa_local_planner::input {
namespace {

TEST(LiveConfiguration, OffIsAutonomyAtOnceAndTakesNothing) {
  Person person;
  person.steer(1.0);
  person.set_mode(OperatorMode::off);
  expect_autonomy(person.cycle(1.1));
  EXPECT_EQ(person.stick(1.15, 1.0F), "");
  EXPECT_EQ(person.stick(1.15, 7.0F), "");  // nobody reads it
  EXPECT_EQ(person.machine.dropped(), 0U);
  EXPECT_EQ(person.cycle(1.15).state, State::autonomy);
}

TEST(LiveConfiguration, AnyModeChangeWhileSteeringIsAutonomyAndNeedsNeutral) {
  for (const OperatorMode mode : {OperatorMode::off, OperatorMode::gesture, OperatorMode::switching}) {
    Person person;
    person.steer(1.0);
    person.set_mode(mode);
    expect_autonomy(person.cycle(1.1));
    person.set_mode(OperatorMode::joystick);
    expect_autonomy(person.cycle_with_stick(1.15, 1.0F));
    EXPECT_EQ(person.steer(1.2).state, State::shared);
  }
}

TEST(LiveConfiguration, AnotherModeLeavesNoHold) {
  Person person;
  person.steer(1.0);
  EXPECT_EQ(person.cycle_with_stick(1.1, 0.0F).state, State::hold);
  person.set_mode(OperatorMode::gesture);
  EXPECT_EQ(person.cycle(1.15).state, State::autonomy);
}

TEST(LiveConfiguration, LostEndsWithTheMode) {
  Parameters p;
  p.on_input_lost = OnInputLost::stop;
  Person person(p);
  person.steer(1.0);
  EXPECT_EQ(person.cycle(1.6).influence, Influence::stop);
  person.set_mode(OperatorMode::off);
  EXPECT_EQ(person.cycle(1.65).influence, Influence::none);
}

/// A change of a parameter while the stick is held half to the left and half forward.
struct Change {
  const char* parameter;
  ParameterValue value;
  State state;      // of the next cycle, before another message comes
  double v, omega;  // what it asks for [m/s, rad/s]
};

TEST(LiveConfiguration, TuningGoesOnAnotherMappingMustBeSeenCentred) {
  const Change changes[] = {
      {"max_vel_x", 0.4, State::shared, 0.4, 0.25},
      {"max_vel_theta", 2.0, State::shared, 0.5, 0.5},  // 0.5^2 * 2
      {"s_omega", 400.0, State::shared, 0.5, 0.25},
      {"linear", std::string("axis"), State::shared, 0.125, 0.25},  // 0.5^2 * 0.5, 0.5^2
      {"dead_zone", 0.6, State::hold, 0.5, 0.0},                    // a release
      {"axis_angular", 1, State::hold, 0.5, 0.0},
      {"joy_topic", std::string("other_joy"), State::hold, 0.5, 0.0},
  };
  for (const Change& change : changes) {
    SCOPED_TRACE(change.parameter);
    Person person;
    person.steer(1.0, 0.5F, 0.5F);
    EXPECT_EQ(set_parameter(person.p, change.parameter, change.value), "");
    person.configure();
    expect_intent(person.cycle(1.1), change.state, Influence::shared, change.v, change.omega);
    EXPECT_EQ(person.cycle_with_stick(1.15, 0.5F, 0.5F).state, change.state);
    EXPECT_EQ(person.steer(1.2, 1.0F, 1.0F).state, State::shared);
  }
}

TEST(LiveConfiguration, DeltaChangesDuringHold) {
  Person person;
  person.steer(1.0);
  person.stick(1.1, 0.0F);
  EXPECT_EQ(person.cycle(1.5).state, State::hold);
  person.p.delta = 0.4;
  person.configure();
  EXPECT_EQ(person.cycle(1.55).state, State::autonomy);
}

TEST(LiveConfiguration, TheTimeoutChangesWhileSilent) {
  Parameters p;
  p.input_timeout = 0.0;
  Person person(p);
  person.steer(1.0);
  EXPECT_EQ(person.cycle(10.0).state, State::shared);
  person.p.input_timeout = 0.5;
  person.configure();
  expect_lost(person.cycle(10.05), Influence::none);
}

}  // namespace
}  // namespace hidwa_local_planner::input
