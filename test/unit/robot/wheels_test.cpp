// SPDX-License-Identifier: BSD-3-Clause
#include "robot/wheels.hpp"

#include <gtest/gtest.h>

#include "robot/urdf_reading.hpp"
#include "unit/robot/urdf_texts.hpp"

namespace hidwa_local_planner::robot {
namespace {

WheelSearch search(const std::string& urdf, const std::string& left = "", const std::string& right = "") {
  const UrdfReading reading = read_urdf(urdf, "base_link");
  EXPECT_TRUE(reading.model) << reading.fault;
  return reading.model ? find_wheels(*reading.model, left, right) : WheelSearch();
}

/// Where they are found.
Wheels wheels_of(const std::string& urdf, const std::string& left = "", const std::string& right = "") {
  const WheelSearch found = search(urdf, left, right);
  EXPECT_TRUE(found.wheels) << found.fault;
  return found.wheels.value_or(Wheels());
}

std::string robot_of(const std::string& more) { return "<robot name='r'><link name='base_link'/>" + more + "</robot>"; }

void expect_fault(const WheelSearch& found, std::initializer_list<const char*> parts) {
  EXPECT_FALSE(found.wheels);
  for (const char* part : parts) EXPECT_NE(found.fault.find(part), std::string::npos) << part << " in " << found.fault;
}

TEST(Wheels, LimitPresent) {
  const Wheels found = wheels_of(base_text());
  EXPECT_EQ(found.left, "wheel_left_joint");
  EXPECT_EQ(found.right, "wheel_right_joint");
  EXPECT_NEAR(found.separation, 0.4044, 1e-12);  // 0.2022 + 0.2022 m
  EXPECT_EQ(found.radius, 0.0985);
  EXPECT_EQ(found.max_velocity, 10.152);
}

TEST(Wheels, LimitAbsent) {
  // As TurtleBot3: wheels 0.16 m apart, turned origins, cylinders along the joints' z, no <limit>.
  const auto wheel = [](const std::string& side, const std::string& y) {
    return joint_text("wheel_" + side + "_joint", "continuous", "base_link", "wheel_" + side, "0.0 " + y + " 0.023",
                      "-1.57 0 0", "<axis xyz='0 0 1'/>") +
           link_text("wheel_" + side, "<cylinder length='0.018' radius='0.033'/>");
  };
  const Wheels found = wheels_of("<robot name='burger'><link name='base_footprint'/>" +
                                 joint_text("base_joint", "fixed", "base_footprint", "base_link", "0 0 0.01") +
                                 "<link name='base_link'/>" + wheel("left", "0.08") + wheel("right", "-0.080") +
                                 joint_text("caster_back_joint", "fixed", "base_link", "caster", "-0.081 0 -0.004") +
                                 link_text("caster", "<box size='0.03 0.009 0.02'/>") + "</robot>");
  EXPECT_NEAR(found.separation, 0.16, 1e-12);
  EXPECT_EQ(found.radius, 0.033);
  EXPECT_EQ(found.max_velocity, 0.0);
}

// Wheels 0.4 m apart.
Wheels of_two(const std::string& left_limit, const std::string& left_tyre, const std::string& right_limit,
              const std::string& right_tyre) {
  return wheels_of(robot_of(wheel_text("left", "0", "0.2", left_limit, left_tyre) +
                            wheel_text("right", "0", "-0.2", right_limit, right_tyre)));
}

TEST(Wheels, TheTighterOfTwoDifferentOnesCounts) {
  const Wheels found = of_two(limit_text("9"), tyre("0.1"), limit_text("7"), tyre("0.09"));
  EXPECT_EQ(found.max_velocity, 7.0);
  EXPECT_EQ(found.slower, "right_joint");
  EXPECT_EQ(found.radius, 0.09);
}

TEST(Wheels, OneJointsLimitWillDo) {
  EXPECT_EQ(of_two("", tyre("0.1"), limit_text("7"), tyre("0.1")).max_velocity, 7.0);
}

TEST(Wheels, OriginsOfFixedJointsBetweenAreAdded) {
  const auto side = [](const std::string& name, const std::string& y, const std::string& turned) {
    return joint_text(name + "_mount_joint", "fixed", "base_link", name + "_mount", "0.05 " + y + " 0.06", turned) +
           "<link name='" + name + "_mount'/>" +
           joint_text(name + "_joint", "continuous", name + "_mount", name, "0 0.05 0", "0 0 0",
                      kAxisY + limit_text("5")) +
           link_text(name, tyre("0.08"), kAcross);
  };
  // Left at 0.15 + 0.05; the right mount is turned by half a turn, so that its +0.05 goes the other way:
  // -0.15 - 0.05.
  const Wheels found = wheels_of(robot_of(side("left", "0.15", "0 0 0") + side("right", "-0.15", "0 0 3.14159265359")));
  EXPECT_NEAR(found.separation, 0.4, 1e-9);
  EXPECT_EQ(found.left, "left_joint");
}

TEST(Wheels, SphereOrVisualGeometryWillDo) {
  EXPECT_EQ(wheels_of(base_text(limit_text("5"), "<sphere radius='0.07'/>")).radius, 0.07);
  const auto visual = [](const std::string& side, const std::string& y) {
    return joint_text(side, "continuous", "base_link", side + "_link", "0 " + y + " 0.1", "0 0 0", kAxisY) +
           "<link name='" + side + "_link'><visual><origin rpy='" + kAcross + "'/><geometry>" + tyre("0.06") +
           "</geometry></visual><collision><geometry><mesh "
           "filename='package://r/tyre.stl'/></geometry></collision></link>";
  };
  EXPECT_EQ(wheels_of(robot_of(visual("l", "0.2") + visual("r", "-0.2"))).radius, 0.06);
}

TEST(Wheels, AMeshHasNoRadius) {
  const Wheels found = wheels_of(base_text(limit_text("5"), "<mesh filename='package://r/tyre.stl'/>"));
  EXPECT_EQ(found.radius, 0.0);
  EXPECT_NE(found.no_radius.find("_joint"), std::string::npos) << found.no_radius;
  EXPECT_NE(found.no_radius.find("set max_wheel_speed"), std::string::npos) << found.no_radius;
}

TEST(Wheels, ACylinderAcrossTheAxisDoesNotRoll) {
  const std::string upright = joint_text("l", "continuous", "base_link", "l_link", "0 0.2 0.1", "0 0 0", kAxisY) +
                              link_text("l_link", tyre("0.06")) +
                              joint_text("r", "continuous", "base_link", "r_link", "0 -0.2 0.1", "0 0 0", kAxisY) +
                              link_text("r_link", tyre("0.06"));
  const Wheels found = wheels_of(robot_of(upright));
  EXPECT_EQ(found.radius, 0.0);
  EXPECT_NE(found.no_radius.find("does not lie along the joint's axis"), std::string::npos);
}

TEST(Wheels, NonsenseIsAFaultThatNamesTheJoint) {
  expect_fault(search(base_text(limit_text("5"), tyre("0"))), {"wheel_left_joint", "radius of 0 m", "correct it"});
  expect_fault(search(base_text(limit_text("5"), tyre("-0.1"))), {"wheel_left_joint", "radius of -0.1 m"});
  expect_fault(search(base_text(limit_text("5"), tyre("98.5"))), {"wheel_left_joint", "radius of 98.5 m"});
  expect_fault(search(base_text(limit_text("0"))), {"wheel_left_joint", "velocity> is 0 rad/s", "remove <limit>"});
  expect_fault(search(base_text(limit_text("-3"))), {"wheel_left_joint", "velocity> is -3 rad/s"});
}

TEST(Wheels, MissingJointsAreNamedWithWhatThereIs) {
  expect_fault(search(base_text(), "left", "wheel_right_joint"),
               {"left: there is no such joint (wheel_joints)", "wheel_left_joint, wheel_right_joint"});
  expect_fault(search(base_text(), "wheel_left_joint", "right"), {"right: there is no such joint (wheel_joints)"});
  expect_fault(search(base_text(), "wheel_left_joint", ""), {"wheel_joints names one joint"});
  expect_fault(search(base_text(), "wheel_left_joint", "wheel_left_joint"), {"0 m apart"});
  expect_fault(search(robot_of(""), "l", "r"), {"l: there is no such joint", "none"});
}

TEST(Wheels, NamedJointsMustTurnAboutY) {
  const std::string more =
      joint_text("fixed_joint", "fixed", "base_link", "a", "0 0 0") + "<link name='a'/>" +
      joint_text("yaw_joint", "continuous", "base_link", "b", "0 0 0", "0 0 0", "<axis xyz='0 0 1'/>") +
      "<link name='b'/>";
  const std::string urdf = base_text(limit_text("5"), tyre("0.1"), more);
  expect_fault(search(urdf, "fixed_joint", "wheel_right_joint"), {"fixed_joint: it does not turn"});
  expect_fault(search(urdf, "yaw_joint", "wheel_right_joint"), {"yaw_joint: it turns about (0, 0, 1) of base_link"});
}

std::string four_wheels() {
  std::string text = "<robot name='skid'><link name='base_link'/>";
  for (const char* x : {"0.2", "-0.2"}) {
    for (const char* y : {"0.25", "-0.25"}) {
      const std::string name = std::string(x[0] == '-' ? "rear" : "front") + (y[0] == '-' ? "_right" : "_left");
      text += wheel_text(name, x, y, limit_text("6"), tyre("0.1"));
    }
  }
  return text + "</robot>";
}

TEST(Wheels, FourWheelsNeedNames) {
  const WheelSearch found = search(four_wheels());
  EXPECT_TRUE(found.undecided);
  expect_fault(found,
               {"front_left_joint and front_right_joint", "rear_left_joint and rear_right_joint", "by wheel_joints"});
  EXPECT_NEAR(wheels_of(four_wheels(), "rear_left_joint", "rear_right_joint").separation, 0.5, 1e-12);
}

TEST(Wheels, CastersOnSwivelsAreNoDrivingWheels) {
  std::string casters;
  for (const char* side : {"1", "-1"}) {
    const std::string name = std::string("caster") + side;
    casters +=
        joint_text(name + "_swivel", "continuous", "base_link", name,
                   "0.2 " + std::string(side[0] == '-' ? "-" : "") + "0.15 0.1", "0 0 0", "<axis xyz='0 0 1'/>") +
        "<link name='" + name + "'/>" + wheel_text(name + "_wheel", "-0.02", "0", "", tyre("0.03"), name);
  }
  const Wheels found = wheels_of(base_text(limit_text("5"), tyre("0.1"), casters));
  EXPECT_EQ(found.left, "wheel_left_joint");
}

TEST(Wheels, ARobotWithoutWheelsIsUndecided) {
  const WheelSearch found = search(robot_of(""));
  EXPECT_TRUE(found.undecided);
  expect_fault(found, {"no two joints turn freely about y"});
}

}  // namespace
}  // namespace hidwa_local_planner::robot
