// SPDX-License-Identifier: BSD-3-Clause
#include "robot/outline.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/footprint.hpp"
#include "robot/urdf_reading.hpp"
#include "unit/robot/urdf_texts.hpp"

namespace hidwa_local_planner::robot {
namespace {

Outline outline(const std::string& inside) {
  const UrdfReading reading = read_urdf("<robot name='r'>" + inside + "</robot>", "base_link");
  EXPECT_TRUE(reading.model) << reading.fault;
  return reading.model ? outline_of(*reading.model) : Outline();
}

/// How far it extends ahead and to the left.
Point extent(const Outline& outline) {
  Point most(0.0, 0.0);
  for (const Point& corner : outline.corners) most = most.cwiseMax(corner);
  return most;
}

TEST(Outline, OfABoxOffTheBase) {
  // Turned by a quarter about z at (0.1, 0): 0.4 m long across, 0.2 m wide along.
  const Outline result = outline("<link name='base_link'/>" +
                                 joint_text("j", "fixed", "base_link", "body", "0.1 0 0.3", "0 0 1.5707963268") +
                                 link_text("body", "<box size='0.4 0.2 0.1'/>"));
  ASSERT_EQ(result.corners.size(), 4u);
  const Polygon expected{{0.0, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {0.0, 0.2}};
  for (const Point& corner : expected) {
    EXPECT_TRUE(std::any_of(result.corners.begin(), result.corners.end(), [&](const Point& found) {
      return (found - corner).norm() < 1e-9;
    })) << corner.transpose();
  }
  EXPECT_EQ(result.fault, "");
}

TEST(Outline, OfALyingCylinderIsARectangle) {
  const Outline result = outline(link_text("base_link", "<cylinder radius='0.1' length='0.5'/>", kAcross));
  const Point most = extent(result);
  EXPECT_NEAR(most.y(), 0.25, 1e-9);
  EXPECT_NEAR(most.x(), 0.1, 0.0005);
  EXPECT_GE(most.x(), 0.1 - 1e-12);
}

TEST(Outline, ARoundRobotIsACircleThatContainsIt) {
  const Outline result = outline(link_text("base_link", "<cylinder radius='0.275' length='0.2'/>"));
  const Footprint footprint = Footprint::from_outline(result.corners, 0.0);
  ASSERT_TRUE(footprint.is_circle());
  // 0.275 / cos(pi / 32) = 0.27633 m.
  EXPECT_NEAR(footprint.radius(), 0.27633, 1e-5);
}

TEST(Outline, CoversEveryLinkWhateverItsHeight) {
  const Outline result = outline(link_text("base_link", "<sphere radius='0.1'/>") +
                                 joint_text("j", "continuous", "base_link", "screen", "0.2 0 1.2", "0 0 0", kAxisY) +
                                 link_text("screen", "<box size='0.02 0.36 0.24'/>"));
  EXPECT_NEAR(extent(result).x(), 0.21, 1e-9);  // 0.2 + 0.5 x 0.02 m
  EXPECT_NEAR(extent(result).y(), 0.18, 1e-9);  // 0.5 x 0.36 m
}

TEST(Outline, MeshesAndShapesWithoutSizeAreSkippedAndNamed) {
  const Outline result = outline(
      link_text("base_link", "<sphere radius='0.1'/>") + joint_text("a", "fixed", "base_link", "body", "0 0 0") +
      link_text("body", "<mesh filename='package://r/body.stl'/>") +
      joint_text("b", "fixed", "base_link", "flat", "0 0 0") + link_text("flat", "<cylinder radius='0' length='1'/>"));
  const std::vector<std::string> expected{"body", "flat"};
  EXPECT_EQ(result.skipped, expected);
  EXPECT_FALSE(result.corners.empty());
}

TEST(Outline, NothingToProjectIsAFault) {
  const Outline result = outline("<link name='base_link'/>");
  EXPECT_TRUE(result.corners.empty());
  EXPECT_NE(result.fault.find("no link has"), std::string::npos);
}

TEST(Outline, WhatReachesTooFarIsAFaultThatNamesTheLink) {
  const Outline result = outline(link_text("base_link", "<box size='275 275 10'/>"));
  EXPECT_TRUE(result.corners.empty());
  EXPECT_NE(result.fault.find("base_link"), std::string::npos) << result.fault;
}

}  // namespace
}  // namespace hidwa_local_planner::robot
