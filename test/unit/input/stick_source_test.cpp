// SPDX-License-Identifier: BSD-3-Clause
#include "input/stick_reading.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace hidwa_local_planner::input {
namespace {

OperatorCommand command_from(const StickMessage& message, const Parameters& p) {
  StickReading reading;
  EXPECT_EQ(read_stick(message, {p}, reading), "");
  return command_of(reading, p);
}

StickMessage message_of(std::vector<float> axes, std::vector<int> buttons = {}) {
  StickMessage message;
  message.axes = std::move(axes);
  message.buttons = std::move(buttons);
  return message;
}

TEST(StickSource, FullVelocityAndTheMappedTurn) {
  Parameters p;  // max_vel_x 0.5, max_vel_theta 1
  const OperatorCommand command = command_from(message_of({-0.5F, 0.9F}), p);
  EXPECT_TRUE(command.active);
  EXPECT_DOUBLE_EQ(command.u_h.v, 0.5);        // v_max, whatever the other axis says
  EXPECT_DOUBLE_EQ(command.u_h.omega, -0.25);  // -(0.5^2)
}

TEST(StickSource, DeadZoneHoldsItsOwnFloat) {
  const Parameters p;
  EXPECT_FALSE(command_from(message_of({0.1F, 0.0F}), p).active);  // as a double 0.1F is above 0.1
  EXPECT_FALSE(command_from(message_of({-0.1F, 0.0F}), p).active);
  const OperatorCommand above = command_from(message_of({std::nextafter(0.1F, 1.0F), 0.0F}), p);
  EXPECT_TRUE(above.active);
  EXPECT_NEAR(above.u_h.omega, 0.01, 1e-8);
}

TEST(StickSource, TheOtherAxisAloneIsNoInputAtFullVelocity) {
  EXPECT_FALSE(command_from(message_of({0.0F, 1.0F}), Parameters()).active);
}

TEST(StickSource, LinearFromTheAxis) {
  Parameters p;
  p.linear = LinearPolicy::axis;
  const OperatorCommand both = command_from(message_of({1.0F, 0.5F}), p);
  EXPECT_DOUBLE_EQ(both.u_h.v, 0.125);  // 0.5^2 * 0.5 m/s
  EXPECT_DOUBLE_EQ(both.u_h.omega, 1.0);
  const OperatorCommand back = command_from(message_of({0.0F, -1.0F}), p);
  EXPECT_TRUE(back.active);
  EXPECT_DOUBLE_EQ(back.u_h.v, -0.5);  // u_h is not clipped
  EXPECT_FALSE(command_from(message_of({0.1F, 0.1F}), p).active);
}

TEST(StickSource, SharedControlAtItsEdges) {
  Parameters p;
  p.max_vel_x = 0.7;
  p.max_vel_theta = 1.5;
  const auto command = [&p](float angular) { return command_from(message_of({angular, 0.0F}), p); };
  for (const float none : {0.0F, 0.1F, -0.1F}) EXPECT_FALSE(command(none).active) << none;
  const float above = std::nextafter(0.1F, 1.0F);
  EXPECT_NEAR(command(above).u_h.omega, 0.015, 1e-8);  // 0.1^2 * 1.5
  EXPECT_NEAR(command(-above).u_h.omega, -0.015, 1e-8);
  EXPECT_DOUBLE_EQ(command(0.5F).u_h.omega, 0.375);  // 0.5^2 * 1.5
  EXPECT_DOUBLE_EQ(command(1.0F).u_h.omega, 1.5);    // 1^2 * 1.5
  EXPECT_DOUBLE_EQ(command(-1.0F).u_h.omega, -1.5);
  for (const float any : {above, -above, 0.5F, -1.0F}) EXPECT_DOUBLE_EQ(command(any).u_h.v, 0.7);  // v_max
}

// Whatever the linear policy: SW takes both axes.
TEST(StickSource, SwitchingAtItsEdges) {
  for (const LinearPolicy linear : {LinearPolicy::v_max, LinearPolicy::axis, LinearPolicy::current}) {
    Parameters p;
    p.mode = OperatorMode::switching;
    p.linear = linear;
    p.max_vel_x = 0.7;
    p.max_vel_theta = 1.5;
    const auto command = [&p](float angular, float along) {
      return command_from(message_of({angular, along}, {0}), p);
    };
    const float above = std::nextafter(0.1F, 1.0F);
    for (const float none : {0.0F, 0.1F, -0.1F}) {
      EXPECT_FALSE(command(none, none).active);
      EXPECT_DOUBLE_EQ(command(1.0F, none).u_h.v, 0.0);
      EXPECT_DOUBLE_EQ(command(none, 1.0F).u_h.omega, 0.0);
    }
    EXPECT_NEAR(command(above, -above).u_h.omega, 0.015, 1e-8);  // 0.1^2 * 1.5
    EXPECT_NEAR(command(above, -above).u_h.v, -0.007, 1e-8);     // -(0.1^2) * 0.7
    EXPECT_DOUBLE_EQ(command(-0.5F, 0.5F).u_h.omega, -0.375);    // -(0.5^2) * 1.5
    EXPECT_DOUBLE_EQ(command(-0.5F, 0.5F).u_h.v, 0.175);         // 0.5^2 * 0.7
    EXPECT_DOUBLE_EQ(command(1.0F, -1.0F).u_h.omega, 1.5);
    EXPECT_DOUBLE_EQ(command(1.0F, -1.0F).u_h.v, -0.7);
    EXPECT_TRUE(command(0.0F, 1.0F).active);
  }
}

TEST(StickSource, IndicesAndSigns) {
  Parameters p;
  p.linear = LinearPolicy::axis;
  p.axis_angular = {2, true};  // right is +1
  p.axis_linear = {3, true};   // down is +1
  const OperatorCommand command = command_from(message_of({0.3F, 0.3F, 0.5F, -1.0F}), p);
  EXPECT_DOUBLE_EQ(command.u_h.omega, -0.25);
  EXPECT_DOUBLE_EQ(command.u_h.v, 0.5);
}

TEST(StickSource, EnableButton) {
  Parameters p;
  p.enable_button = 1;
  EXPECT_FALSE(command_from(message_of({1.0F, 0.0F}, {0, 0}), p).active);
  const OperatorCommand straight = command_from(message_of({0.0F, 0.0F}, {0, 1}), p);
  EXPECT_TRUE(straight.active);  // centred means straight on
  EXPECT_DOUBLE_EQ(straight.u_h.v, 0.5);
  EXPECT_DOUBLE_EQ(straight.u_h.omega, 0.0);
  EXPECT_DOUBLE_EQ(command_from(message_of({1.0F, 0.0F}, {0, 1}), p).u_h.omega, 1.0);
}

TEST(StickSource, FaultsNameTheThingAndTheRemedy) {
  Parameters p;
  StickReading reading;
  reading.angular = 0.75F;
  p.axis_angular = {3};
  EXPECT_EQ(read_stick(message_of({0.0F, 0.0F}), {p}, reading),
            "axis_angular = 3, but the message has only axes 0 to 1: set axis_angular to one that the device has");
  EXPECT_EQ(read_stick(message_of({}), {p}, reading),
            "axis_angular = 3, but the message has no axes: set axis_angular to one that the device has");
  p.axis_angular = {0};
  p.enable_button = 5;
  EXPECT_EQ(read_stick(message_of({0.0F, 0.0F}, {0}), {p}, reading),
            "enable_button = 5, but the message has only buttons 0 to 0: set enable_button to one that the "
            "device has, "
            "or to -1 for none");
  p.enable_button = 0;
  EXPECT_EQ(read_stick(message_of({0.0F, 0.0F}, {7}), {p}, reading),
            "buttons[0] = 7 is neither 0 nor 1: look at the sender, or set enable_button to another button");
  p.enable_button = -1;
  EXPECT_EQ(read_stick(message_of({1.5F, 0.0F}), {p}, reading),
            "axes[0] = 1.5 is outside [-1, 1]: scale it at the sender, or set axis_angular to another axis");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_EQ(read_stick(message_of({0.0F, nan}), {p}, reading),
            "axes[1] is not a finite number: look at the sender, or set axis_linear to another axis");
  EXPECT_NE(read_stick(message_of({-infinite, 0.0F}), {p}, reading), "");
  EXPECT_EQ(reading.angular, 0.75F);  // untouched by all of them
}

TEST(StickSource, WhatIsNotReadMayBeMissingOrOutOfRange) {
  Parameters p;
  EXPECT_DOUBLE_EQ(command_from(message_of({1.0F}), p).u_h.omega, 1.0);  // one axis is enough at full velocity
  EXPECT_DOUBLE_EQ(command_from(message_of({1.0F, 0.0F, 8.0F}), p).u_h.omega, 1.0);
  p.linear = LinearPolicy::axis;
  StickReading reading;
  EXPECT_NE(read_stick(message_of({1.0F}), {p}, reading), "");
}

// Triggers that are not mapped may say anything; where nothing is read of the second axis, that too counts as 0.
TEST(StickSource, WhatIsNotReadMayBeNoNumber) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Parameters p;
  EXPECT_DOUBLE_EQ(command_from(message_of({1.0F, 0.0F, nan}), p).u_h.omega, 1.0);
  p.stop_pull = 0.0;
  for (const float value : {nan, 1.2F, -std::numeric_limits<float>::infinity()}) {
    StickReading reading;
    EXPECT_EQ(read_stick(message_of({1.0F, value}), {p}, reading), "");
    EXPECT_EQ(reading.linear, 0.0F);
    EXPECT_EQ(reading.angular, 1.0F);
  }
}

TEST(StickSource, AStopIsReadFromWhateverCanBeRead) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Parameters p;
  p.stop_button = 1;
  const StopReading both = stop_reading_of(message_of({nan, -0.5F}, {7, 1}), {p});
  EXPECT_TRUE(both.button);
  ASSERT_TRUE(both.back);
  EXPECT_DOUBLE_EQ(*both.back, 0.5);
  EXPECT_FALSE(stop_reading_of(message_of({}, {1}), {p}).button);
  EXPECT_FALSE(stop_reading_of(message_of({0.0F}, {}), {p}).back);
  EXPECT_FALSE(stop_reading_of(message_of({0.0F, nan}, {}), {p}).back);
  p.stop_pull = 0.0;
  p.stop_button = -1;
  EXPECT_FALSE(stop_reading_of(message_of({0.0F, -1.0F}, {1, 1}), {p}).back);
  EXPECT_FALSE(stop_reading_of(message_of({0.0F, -1.0F}, {1, 1}), {p}).button);
}

TEST(StickSource, DriversOvershootByRounding) {
  EXPECT_DOUBLE_EQ(command_from(message_of({1.00003F, 0.0F}), Parameters()).u_h.omega, 1.0);
  EXPECT_DOUBLE_EQ(command_from(message_of({-1.01F, 0.0F}), Parameters()).u_h.omega, -1.0);
  StickReading reading;
  EXPECT_NE(read_stick(message_of({1.02F, 0.0F}), {Parameters()}, reading), "");
}

}  // namespace
}  // namespace hidwa_local_planner::input
