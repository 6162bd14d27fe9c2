// SPDX-License-Identifier: BSD-3-Clause
#include "robot/urdf_reading.hpp"

#include <algorithm>

#include <console_bridge/console.h>
#include <gtest/gtest.h>

#include "unit/robot/urdf_texts.hpp"

namespace hidwa_local_planner::robot {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Joint joint_of(const Model& model, const std::string& name) {
  return *std::find_if(model.joints.begin(), model.joints.end(), [&](const Joint& j) { return j.name == name; });
}

TEST(UrdfReading, JointsLieInTheBaseFrame) {
  const UrdfReading reading = read_urdf(base_text(), "base_link");
  ASSERT_TRUE(reading.model) << reading.fault;
  EXPECT_EQ(reading.warning, "");
  EXPECT_EQ(reading.model->links.size(), 3u);
  const Joint left = joint_of(*reading.model, "wheel_left_joint");
  EXPECT_EQ(left.turning, Turning::freely);
  EXPECT_TRUE(left.fixed_to_base);
  EXPECT_TRUE(left.position.isApprox(Eigen::Vector3d(0.0, 0.2022, 0.0985)));
  EXPECT_TRUE(left.axis.isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_EQ(left.max_velocity.value_or(0.0), 10.152);
}

TEST(UrdfReading, OriginsAreComposedAlongTheTree) {
  // The carrier is turned by a quarter about z: its x is the base's y. The joint is turned by another quarter
  // about x.
  const std::string text =
      "<robot name='r'><link name='root'/>" + joint_text("base_joint", "fixed", "root", "base_link", "0 0 0.1") +
      "<link name='base_link'/>" +
      joint_text("carrier_joint", "fixed", "base_link", "carrier", "0.05 0.1 0", "0 0 1.5707963268") +
      "<link name='carrier'/>" +
      joint_text("arm_joint", "revolute", "carrier", "arm", "0.1 0 0", "1.5707963268 0 0",
                 "<axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='1' velocity='1'/>") +
      "<link name='arm'/>" + joint_text("tip_joint", "continuous", "arm", "tip", "0 0 0.3", "0 0 0", kAxisY) +
      "<link name='tip'/></robot>";
  const UrdfReading reading = read_urdf(text, "/robot/base_link");
  ASSERT_TRUE(reading.model) << reading.fault;
  EXPECT_EQ(reading.model->base, "base_link");
  const Joint arm = joint_of(*reading.model, "arm_joint");
  // (0.05, 0.1, 0) + Rz(90) (0.1, 0, 0) = (0.05, 0.2, 0); the root lies 0.1 m below and counts for nothing.
  EXPECT_TRUE(arm.position.isApprox(Eigen::Vector3d(0.05, 0.2, 0.0), 1e-9));
  EXPECT_EQ(arm.turning, Turning::within_bounds);
  // Rz(90) Rx(90) z = Rz(90) (0, -1, 0) = (1, 0, 0).
  EXPECT_TRUE(arm.axis.isApprox(Eigen::Vector3d::UnitX(), 1e-9));
  EXPECT_TRUE(arm.fixed_to_base);
  const Joint tip = joint_of(*reading.model, "tip_joint");
  EXPECT_TRUE(tip.position.isApprox(Eigen::Vector3d(0.35, 0.2, 0.0), 1e-9));
  EXPECT_FALSE(tip.fixed_to_base);
  EXPECT_FALSE(tip.max_velocity);
}

TEST(UrdfReading, AnUnknownBaseFrameIsSaidAndTheRootTaken) {
  const UrdfReading reading = read_urdf(base_text(), "base_footprint");
  ASSERT_TRUE(reading.model);
  EXPECT_EQ(reading.model->base, "base_link");
  EXPECT_TRUE(has(reading.warning, "no link base_footprint")) << reading.warning;
}

TEST(UrdfReading, WhatIsNoUrdfIsAFaultAndNothingIsThrown) {
  const std::string good = base_text();
  const std::string texts[] = {"",
                               " ",
                               "nonsense",
                               "<robot",
                               "<robot/>",
                               "<robot name='r'/>",
                               "<sdf version='1.6'/>",
                               good.substr(0, good.size() / 2),
                               std::string(1000, '<'),
                               std::string("\0<robot>", 8)};
  for (const std::string& text : texts) {
    const UrdfReading reading = read_urdf(text, "base_link");
    EXPECT_FALSE(reading.model) << text;
    EXPECT_TRUE(has(reading.fault, "not a valid URDF")) << reading.fault;
    EXPECT_TRUE(has(reading.fault, "check_urdf")) << reading.fault;
  }
}

TEST(UrdfReading, EveryBeginningOfAGoodTextIsReadOrRefused) {
  const std::string good = base_text();
  for (std::size_t length = 0; length < good.size(); length += 7) {
    const UrdfReading reading = read_urdf(good.substr(0, length), "base_link");
    EXPECT_NE(reading.model.has_value(), !reading.fault.empty()) << length;
  }
}

TEST(UrdfReading, FaultsNameTheJoint) {
  EXPECT_TRUE(has(read_urdf(base_text("<limit effort='6' velocity='fast'/>"), "base_link").fault, "wheel_left_joint"));
  EXPECT_TRUE(has(read_urdf(base_text("<limit effort='6'/>"), "base_link").fault, "wheel_left_joint"));
  EXPECT_TRUE(has(read_urdf(base_text("<limit effort='6' velocity='nan'/>"), "base_link").fault, "wheel_left_joint"));
  const std::string orphan =
      base_text(limit_text("10"), tyre("0.1"), joint_text("lost_joint", "fixed", "nowhere", "x", "0 0 0"));
  EXPECT_TRUE(has(read_urdf(orphan, "base_link").fault, "lost_joint")) << read_urdf(orphan, "base_link").fault;
}

// urdfdom logs "... material 'NAME' ..." with NAME as part of printf's format.
TEST(UrdfReading, NamesAreNoFormats) {
  for (const std::string name : {"%s%s%s%s", "%n%n", "&#37;s&#37;s", "&#x25;s&#x25;n", "100%"}) {
    std::string material = "<material name='";
    material.append(name).append("'><color rgba='x'/></material>");
    const std::string links = "<link name='base_link'/>" + joint_text("j", "fixed", "base_link", name, "0 0 0");
    for (const std::string& inside : {material, links, links + "<link name='" + name + "'/>", links + material}) {
      const UrdfReading reading = read_urdf("<robot name='" + name + "'>" + inside + "</robot>", "base_link");
      EXPECT_NE(reading.model.has_value(), !reading.fault.empty());
      if (!reading.model) {
        EXPECT_TRUE(has(reading.fault, "with a %")) << reading.fault;
      }
    }
  }
}

TEST(UrdfReading, APercentSignMayStandInAGoodText) {
  const std::string good = base_text();
  std::string text = good;
  text.insert(text.rfind("</robot>"), "<!-- 50% of the load -->");
  const UrdfReading reading = read_urdf(text, "base_link");
  ASSERT_TRUE(reading.model) << reading.fault;
  EXPECT_EQ(reading.model->links.size(), read_urdf(good, "base_link").model->links.size());
}

TEST(UrdfReading, LinksInACircleEnd) {
  const std::string circle = joint_text("a", "fixed", "base_link", "one", "0 0 0") + "<link name='one'/>" +
                             joint_text("b", "fixed", "one", "two", "0 0 0") + "<link name='two'/>" +
                             joint_text("c", "fixed", "two", "one", "0 0 0");
  const UrdfReading reading = read_urdf(base_text(limit_text("10"), tyre("0.1"), circle), "base_link");
  EXPECT_NE(reading.model.has_value(), !reading.fault.empty());
}

TEST(UrdfReading, TheLogOfOthersComesBack) {
  console_bridge::OutputHandler* const before = console_bridge::getOutputHandler();
  read_urdf("nonsense", "base_link");
  EXPECT_EQ(console_bridge::getOutputHandler(), before);
  read_urdf("50% nonsense", "base_link");
  EXPECT_EQ(console_bridge::getOutputHandler(), before);
  console_bridge::restorePreviousOutputHandler();
  EXPECT_EQ(console_bridge::getOutputHandler(), before);
}

}  // namespace
}  // namespace hidwa_local_planner::robot
