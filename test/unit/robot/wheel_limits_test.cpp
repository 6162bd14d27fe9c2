// SPDX-License-Identifier: BSD-3-Clause
#include "robot/wheel_limits.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/motion/velocity_limits.hpp"

namespace hidwa_local_planner::robot {
namespace {

Wheels wheels(double velocity) {
  Wheels w;
  w.left = "left_joint";
  w.right = "right_joint";
  w.separation = 0.4;
  w.radius = 0.1;
  w.max_velocity = velocity;
  w.slower = velocity > 0.0 ? "left_joint" : "";
  return w;
}

bool says(const LimitedParameters& result, const std::string& part, Remark::Level level = Remark::Level::info) {
  for (const Remark& remark : result.remarks) {
    if (remark.level == level && remark.text.find(part) != std::string::npos) return true;
  }
  return false;
}

TEST(WheelLimits, PresentAndTighterThanTheParameters) {
  const Parameters wanted;  // 0.5 m/s, 1 rad/s
  const LimitedParameters result = limited(wanted, wheels(1.5));
  const Parameters& p = result.parameters;
  EXPECT_TRUE(validate(p).empty());
  EXPECT_NEAR(p.max_vel_x, 0.15, 1e-12);      // 0.1 m x 1.5 rad/s
  EXPECT_NEAR(p.max_vel_theta, 0.75, 1e-12);  // 2 x 0.15 / 0.4
  // 0.15 m/s is less than half of 0.5 m/s: perhaps a placeholder. 0.75 rad/s is more than half of 1 rad/s.
  EXPECT_TRUE(says(result, "left_joint allows 0.15 m/s and holds: max_vel_x 0.5 m/s is more. That is less than half",
                   Remark::Level::warning));
  EXPECT_TRUE(says(result, "left_joint allows 0.75 rad/s and holds: max_vel_theta 1 rad/s is more"));
  // The corners: |v| + |omega| x 0.2 m <= 0.15 m/s.
  const VelocityLimits limits = VelocityLimits::from(p);
  EXPECT_TRUE(limits.wheels_allow({0.05, 0.5}));
  EXPECT_FALSE(limits.wheels_allow({0.051, 0.5}));
  EXPECT_FALSE(limits.wheels_allow({0.15, 0.75}));
}

// A wheel of 33 mm with <limit velocity="1">: 0.033 m/s. At half of what is asked for nothing is suspected.
TEST(WheelLimits, WhatTakesMoreThanHalfIsAWarningWithTheRemedy) {
  Wheels small = wheels(1.0);
  small.radius = 0.033;
  Parameters wanted;
  wanted.max_vel_x = 0.26;
  EXPECT_TRUE(says(limited(wanted, small), "left_joint allows 0.033 m/s", Remark::Level::warning));
  EXPECT_TRUE(says(limited(wanted, small), "set robot_description_param to \"\"", Remark::Level::warning));
  wanted.max_vel_x = 0.066;
  EXPECT_TRUE(says(limited(wanted, small), "left_joint allows 0.033 m/s and holds", Remark::Level::info));
  wanted.max_vel_x = 0.067;
  EXPECT_TRUE(says(limited(wanted, small), "left_joint allows 0.033 m/s and holds", Remark::Level::warning));
  // A parameter that limits the same wheels was meant.
  wanted.max_wheel_speed = 0.03;
  EXPECT_FALSE(says(limited(wanted, small), "", Remark::Level::warning));
}

TEST(WheelLimits, TheSlowestReverseFollows) {
  Parameters wanted;
  wanted.min_vel_x = -0.4;
  EXPECT_NEAR(limited(wanted, wheels(1.5)).parameters.min_vel_x, -0.15, 1e-12);
  wanted.min_vel_x = -0.1;
  EXPECT_EQ(limited(wanted, wheels(1.5)).parameters.min_vel_x, -0.1);
}

TEST(WheelLimits, AbsentLeavesTheParameters) {
  const Parameters wanted;
  const LimitedParameters result = limited(wanted, wheels(0.0));
  for (const ParameterInfo& info : parameter_table()) {
    EXPECT_EQ(get_parameter(result.parameters, info.name), get_parameter(wanted, info.name)) << info.name;
  }
  EXPECT_TRUE(says(result, "left_joint and right_joint have no <limit velocity>"));
}

TEST(WheelLimits, AbsurdIsHeldByTheParameters) {
  const LimitedParameters result = limited(Parameters(), wheels(100.0));
  EXPECT_EQ(result.parameters.max_vel_x, 0.5);
  EXPECT_EQ(result.parameters.max_vel_theta, 1.0);
  EXPECT_TRUE(says(result, "left_joint allows 10 m/s, max_vel_x 0.5 m/s holds"));
  EXPECT_TRUE(says(result, "left_joint allows 50 rad/s, max_vel_theta 1 rad/s holds"));
  EXPECT_EQ(result.remarks.size(), 2u);
  // Beyond the parameter's own range of 20 m/s the set stays valid.
  EXPECT_TRUE(validate(limited(Parameters(), wheels(1e9)).parameters).empty());
}

TEST(WheelLimits, TheParametersMayRestrictFurther) {
  Parameters wanted;
  wanted.max_wheel_speed = 0.2;  // alone: the separation comes from the URDF
  LimitedParameters result = limited(wanted, wheels(10.0));
  EXPECT_TRUE(validate(result.parameters).empty());
  EXPECT_NEAR(result.parameters.max_vel_x, 0.2, 1e-12);
  EXPECT_TRUE(says(result, "left_joint allows 1 m/s, max_wheel_speed 0.2 m/s holds"));
  result = limited(wanted, wheels(1.0));
  EXPECT_NEAR(result.parameters.max_wheel_speed, 0.1, 1e-12);
  EXPECT_TRUE(says(result, "left_joint allows 0.1 m/s and holds: max_wheel_speed 0.2 m/s is more"));
  result = limited(wanted, wheels(0.0));
  EXPECT_NEAR(result.parameters.max_wheel_speed, 0.2, 1e-12);
  EXPECT_NEAR(result.parameters.wheel_separation, 0.4, 1e-12);
}

TEST(WheelLimits, TheSeparationOfTheParametersCountsAndADifferenceIsSaid) {
  Parameters wanted;
  wanted.wheel_separation = 0.404;  // 1 % more
  LimitedParameters result = limited(wanted, wheels(1.0));
  EXPECT_EQ(result.parameters.wheel_separation, 0.404);
  EXPECT_FALSE(says(result, "wheel_separation", Remark::Level::warning));
  wanted.wheel_separation = 0.3;
  result = limited(wanted, wheels(1.0));
  EXPECT_TRUE(says(result, "wheel_separation = 0.3 m holds, but the URDF says 0.4 m", Remark::Level::warning));
  EXPECT_NEAR(result.parameters.max_vel_theta, 2.0 * 0.1 / 0.3, 1e-12);
}

TEST(WheelLimits, AMissingRadiusIsAFaultUntilTheParametersHaveTheSpeed) {
  Wheels mesh = wheels(2.0);
  mesh.radius = 0.0;
  mesh.no_radius = "left_joint: a mesh: set max_wheel_speed";
  Parameters wanted;
  LimitedParameters result = limited(wanted, mesh);
  EXPECT_TRUE(says(result, "left_joint: a mesh: set max_wheel_speed", Remark::Level::fault));
  EXPECT_FALSE(result.parameters.has_wheel_limit());
  wanted.max_wheel_speed = 0.2;
  result = limited(wanted, mesh);
  EXPECT_TRUE(validate(result.parameters).empty());
  EXPECT_NEAR(result.parameters.max_vel_x, 0.2, 1e-12);
  EXPECT_NEAR(result.parameters.wheel_separation, 0.4, 1e-12);
}

TEST(WheelLimits, FaultyParametersStayForTheValidationToName) {
  for (const char* name : {"max_vel_x", "min_vel_x", "max_vel_theta", "wheel_separation", "max_wheel_speed"}) {
    for (const double value : {-99.0, 999.0, std::nan("")}) {
      Parameters wanted;
      set_parameter(wanted, name, value);
      const std::vector<std::string> faults = validate(limited(wanted, wheels(1.0)).parameters);
      EXPECT_EQ(faults.size(), validate(wanted).size()) << name << " " << value;
      EXPECT_FALSE(faults.empty());
    }
  }
}

TEST(WheelLimits, TheSameSideHoldingIsTheSameSubject) {
  Parameters wanted;
  const LimitedParameters before = limited(wanted, wheels(100.0));
  wanted.max_vel_x = 0.4;
  const LimitedParameters after = limited(wanted, wheels(100.0));
  ASSERT_EQ(before.remarks.size(), after.remarks.size());
  for (std::size_t i = 0; i < before.remarks.size(); ++i) {
    EXPECT_EQ(before.remarks[i].subject, after.remarks[i].subject);
  }
}

}  // namespace
}  // namespace hidwa_local_planner::robot
