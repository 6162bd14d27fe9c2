// SPDX-License-Identifier: BSD-3-Clause
#include "input/stick_reading.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace hidwa_local_planner::input {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

OperatorCommand command_from(const StickMessage& message, const Parameters& p) {
  StickReading reading;
  EXPECT_EQ(read_stick(message, {p}, reading), "");
  return command_of(reading, p);
}

std::string fault_of(const StickMessage& message, const Parameters& p) {
  StickReading reading;
  reading.angular = 0.75F;
  const std::string fault = read_stick(message, {p}, reading);
  if (!fault.empty()) {
    EXPECT_EQ(reading.angular, 0.75F);  // untouched
  }
  return fault;
}

StickMessage message_of(std::vector<float> axes, std::vector<int> buttons = {}) {
  StickMessage message;
  message.axes = std::move(axes);
  message.buttons = std::move(buttons);
  return message;
}

struct Row {
  float angular, linear;  // deflections
  bool active;
  double v, omega;  // [m/s, rad/s]
};

/// At max_vel_x 0.7 m/s and max_vel_theta 1.5 rad/s.
void expect_commands(const std::vector<Row>& rows, OperatorMode mode, LinearPolicy linear) {
  Parameters p;
  p.mode = mode;
  p.linear = linear;
  p.max_vel_x = 0.7;
  p.max_vel_theta = 1.5;
  for (const Row& row : rows) {
    SCOPED_TRACE(std::to_string(row.angular) + ", " + std::to_string(row.linear));
    const OperatorCommand command = command_from(message_of({row.angular, row.linear}, {0}), p);
    EXPECT_EQ(command.active, row.active);
    EXPECT_NEAR(command.u_h.v, row.v, 1e-8);
    EXPECT_NEAR(command.u_h.omega, row.omega, 1e-8);
  }
}

const float kAbove = std::nextafter(0.1F, 1.0F);

// As a double 0.1F is above 0.1: the dead zone holds its own float.
TEST(StickSource, FullVelocityAndTheMappedTurn) {
  const std::vector<Row> rows = {
      {0.0F, 0.0F, false, 0.0, 0.0},
      {0.1F, 0.0F, false, 0.0, 0.0},
      {-0.1F, 0.0F, false, 0.0, 0.0},
      {0.0F, 1.0F, false, 0.0, 0.0},     // the other axis alone is no input
      {kAbove, 0.0F, true, 0.7, 0.015},  // v_max, 0.1^2 * 1.5
      {-kAbove, 0.0F, true, 0.7, -0.015},
      {-0.5F, 0.9F, true, 0.7, -0.375},  // v_max, whatever the other axis says; -(0.5^2) * 1.5
      {1.0F, 0.0F, true, 0.7, 1.5},
      {-1.0F, 0.0F, true, 0.7, -1.5},
      {1.00003F, 0.0F, true, 0.7, 1.5},  // drivers overshoot by rounding
      {-1.01F, 0.0F, true, 0.7, -1.5},
  };
  expect_commands(rows, OperatorMode::joystick, LinearPolicy::v_max);
}

// SW takes both axes, whatever the linear policy.
TEST(StickSource, BothAxes) {
  const std::vector<Row> rows = {
      {0.0F, 0.0F, false, 0.0, 0.0},           // centred
      {0.1F, 0.1F, false, 0.0, 0.0},           // |p| <= 0.1
      {-0.1F, -0.1F, false, 0.0, 0.0},         // to the other side, too
      {1.0F, 0.1F, true, 0.0, 1.5},            // each axis has a dead zone of its own
      {-0.1F, 1.0F, true, 0.7, 0.0},           // so has the turn
      {kAbove, -kAbove, true, -0.007, 0.015},  // -(0.1^2) * 0.7, 0.1^2 * 1.5
      {-0.5F, 0.5F, true, 0.175, -0.375},      // 0.5^2 * 0.7, -(0.5^2) * 1.5
      {1.0F, -1.0F, true, -0.7, 1.5},          // u_h is not clipped
      {0.0F, 1.0F, true, 0.7, 0.0},            // the speed alone is input
  };
  expect_commands(rows, OperatorMode::joystick, LinearPolicy::axis);
  for (const LinearPolicy linear : {LinearPolicy::v_max, LinearPolicy::axis, LinearPolicy::current}) {
    expect_commands(rows, OperatorMode::switching, linear);
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

TEST(StickSource, WhatTheDeviceLacksIsNamedWithTheRemedy) {
  struct Index {
    const char* parameter;
    OperatorMode mode;
    bool button;
  };
  const Index all[] = {
      {"axis_angular", OperatorMode::joystick, false},  {"axis_linear", OperatorMode::switching, false},
      {"clutch_axis", OperatorMode::gesture, false},    {"clutch_button", OperatorMode::gesture, true},
      {"toggle_button", OperatorMode::switching, true}, {"enable_button", OperatorMode::joystick, true},
      {"stop_button", OperatorMode::joystick, true},
  };
  for (const Index& index : all) {
    const std::string name = index.parameter;
    Parameters p;
    p.mode = index.mode;
    EXPECT_EQ(set_parameter(p, name, 2), "");
    EXPECT_EQ(fault_of(message_of({0.0F, 0.0F}, {0, 0}), p),
              name + " = 2, but the message has only " + (index.button ? "buttons" : "axes") + " 0 to 1: set " + name +
                  " to one that the device has" + (index.button ? ", or to -1 for none" : ""));
  }
  EXPECT_EQ(fault_of(message_of({}), Parameters()),
            "axis_angular = 0, but the message has no axes: set axis_angular to one that the device has");
}

TEST(StickSource, FaultyValuesAreNamedWithTheRemedy) {
  Parameters p;
  p.enable_button = 0;
  EXPECT_EQ(fault_of(message_of({0.0F, 0.0F}, {7}), p),
            "buttons[0] = 7 is neither 0 nor 1: look at the sender, or set enable_button to another button");
  p.enable_button = -1;
  EXPECT_EQ(fault_of(message_of({1.5F, 0.0F}), p),
            "axes[0] = 1.5 is outside [-1, 1]: scale it at the sender, or set axis_angular to another axis");
  EXPECT_EQ(fault_of(message_of({0.0F, kNan}), p),
            "axes[1] is not a finite number: look at the sender, or set axis_linear to another axis");
  EXPECT_NE(fault_of(message_of({-kInfinite, 0.0F}), p), "");
  EXPECT_NE(fault_of(message_of({1.02F, 0.0F}), p), "");
  p.mode = OperatorMode::gesture;
  p.clutch_axis = {1};
  p.stop_pull = 0.0;
  EXPECT_EQ(fault_of(message_of({0.0F, -2.0F}), p),
            "axes[1] = -2 is outside [-1, 1]: scale it at the sender, or set clutch_axis to another axis");
}

// Triggers that are not mapped may say anything; where nothing is read of the second axis, that too counts as 0.
TEST(StickSource, WhatIsNotReadMayBeMissingOutOfRangeOrNoNumber) {
  Parameters p;
  for (const StickMessage& message :
       {message_of({1.0F}), message_of({1.0F, 0.0F, 8.0F}), message_of({1.0F, 0.0F, kNan})}) {
    EXPECT_DOUBLE_EQ(command_from(message, p).u_h.omega, 1.0);
  }
  p.stop_pull = 0.0;
  for (const float value : {kNan, 1.2F, -kInfinite}) {
    StickReading reading;
    EXPECT_EQ(read_stick(message_of({1.0F, value}), {p}, reading), "");
    EXPECT_EQ(reading.linear, 0.0F);
    EXPECT_EQ(reading.angular, 1.0F);
  }
  p.linear = LinearPolicy::axis;
  EXPECT_NE(fault_of(message_of({1.0F}), p), "");
}

TEST(StickSource, AStopIsReadFromWhateverCanBeRead) {
  Parameters p;
  p.stop_button = 1;
  const StopReading both = stop_reading_of(message_of({kNan, -0.5F}, {7, 1}), {p});
  EXPECT_TRUE(both.button);
  ASSERT_TRUE(both.back);
  EXPECT_DOUBLE_EQ(*both.back, 0.5);
  EXPECT_FALSE(stop_reading_of(message_of({}, {1}), {p}).button);
  EXPECT_FALSE(stop_reading_of(message_of({0.0F}, {}), {p}).back);
  EXPECT_FALSE(stop_reading_of(message_of({0.0F, kNan}, {}), {p}).back);
  p.stop_pull = 0.0;
  p.stop_button = -1;
  const StopReading none = stop_reading_of(message_of({0.0F, -1.0F}, {1, 1}), {p});
  EXPECT_FALSE(none.back);
  EXPECT_FALSE(none.button);
}

}  // namespace
}  // namespace hidwa_local_planner::input
