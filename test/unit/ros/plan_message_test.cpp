// SPDX-License-Identifier: BSD-3-Clause
#include "ros/plan_message.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

/// Along x, so many poses, one every metre.
std::vector<geometry_msgs::PoseStamped> straight(int poses, const std::string& frame = "map") {
  std::vector<geometry_msgs::PoseStamped> plan(static_cast<std::size_t>(poses));
  for (int i = 0; i < poses; ++i) {
    geometry_msgs::PoseStamped& pose = plan[static_cast<std::size_t>(i)];
    pose.header.frame_id = frame;
    pose.pose.position.x = i;
    pose.pose.orientation.w = 1.0;
  }
  return plan;
}

TEST(PlanMessage, ItsPosesAndItsFrame) {
  const PlanMessage read = read_plan(straight(4));
  EXPECT_EQ(read.fault, "");
  EXPECT_EQ(read.frame, "map");
  ASSERT_EQ(read.poses.size(), 4u);
  EXPECT_EQ(read.poses[3].x, 3.0);
}

TEST(PlanMessage, ALeadingSlashIsNoPartOfTheFrame) { EXPECT_EQ(read_plan(straight(2, "/odom")).frame, "odom"); }

TEST(PlanMessage, WhatCannotBeFollowedIsNamed) {
  EXPECT_NE(read_plan({}).fault.find("empty"), std::string::npos);
  auto bad = straight(4);
  bad[3].pose.position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(read_plan(bad).fault.find("not a number"), std::string::npos);
  EXPECT_TRUE(read_plan(bad).poses.empty());
  bad = straight(4);
  bad[3].header.frame_id = "odom";
  EXPECT_NE(read_plan(bad).fault.find("mixes"), std::string::npos);
  EXPECT_NE(read_plan(straight(4, "")).fault.find("no frame"), std::string::npos);
}

// Some global planners leave all orientations zero.
TEST(PlanMessage, AQuaternionOfNoLengthIsNoHeading) {
  auto plan = straight(3);
  plan[2].pose.orientation.w = 0.0;
  plan[1].pose.orientation.w = 0.5;  // a length other than 1 has a heading
  const PlanMessage read = read_plan(plan);
  EXPECT_EQ(read.fault, "");
  ASSERT_EQ(read.poses.size(), 3u);
  EXPECT_EQ(read.poses[1].theta, 0.0);
  EXPECT_TRUE(std::isnan(read.poses[2].theta));
}

}  // namespace
}  // namespace hidwa_local_planner
