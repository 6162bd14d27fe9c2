// SPDX-License-Identifier: BSD-3-Clause
#include "ros/odometry_input.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

// A clock that nobody has set.
LoopTime at(double seconds) { return {seconds, ros::Time(seconds)}; }

nav_msgs::Odometry driving(double v, double stamp) {
  nav_msgs::Odometry message;
  message.header.stamp.fromSec(stamp);
  message.twist.twist.linear.x = v;
  return message;
}

TEST(OdometryInput, NothingYet) {
  const OdometryInput::Reading reading = OdometryInput().read(10.0, 0.5);
  EXPECT_FALSE(reading.velocity);
  EXPECT_NE(reading.fault.find("odom_topic"), std::string::npos);
}

TEST(OdometryInput, OldByReceiveTime) {
  OdometryInput input;
  input.receive(driving(0.3, 0.0), at(10.0));  // no stamp
  ASSERT_TRUE(input.read(10.4, 0.5).velocity);
  EXPECT_EQ(input.read(10.4, 0.5).velocity->v, 0.3);
  EXPECT_FALSE(input.read(10.6, 0.5).velocity);
}

TEST(OdometryInput, OldByStamp) {
  OdometryInput input;
  input.receive(driving(0.3, 8.0), at(10.0));  // late on the way
  EXPECT_FALSE(input.read(10.1, 0.5).velocity);
  EXPECT_NE(input.read(10.1, 0.5).fault.find("2.10 s old"), std::string::npos);
}

TEST(OdometryInput, AStampFromTheFutureDoesNotKeepItFresh) {
  OdometryInput input;
  input.receive(driving(0.3, 99.0), at(10.0));
  EXPECT_TRUE(input.read(10.1, 0.5).velocity);
  EXPECT_FALSE(input.read(11.0, 0.5).velocity);
}

TEST(OdometryInput, WhatIsNoNumberIsDropped) {
  ros::Time::init();
  OdometryInput input;
  input.receive(driving(0.3, 0.0), at(10.0));
  input.receive(driving(std::numeric_limits<double>::quiet_NaN(), 0.0), at(10.1));
  EXPECT_EQ(input.read(10.2, 0.5).velocity->v, 0.3);
}

// Frames that no velocity of a robot is given in, and a velocity to the side that lasts.
TEST(OdometryInput, WhatIsOddAboutTheSenderIsNamed) {
  const auto advice = [](const char* frame, const char* child, double v, double sideways, int messages) {
    OdometryInput input;
    nav_msgs::Odometry message = driving(v, 0.0);
    message.header.frame_id = frame;
    message.child_frame_id = child;
    message.twist.twist.linear.y = sideways;
    for (int i = 0; i < messages; ++i) input.receive(message, at(10.0 + 0.05 * i));
    return input.advice("base_link", [](const std::string& name) { return name == "base_footprint"; });
  };
  EXPECT_EQ(advice("odom", "base_link", 0.5, 0.0, 1), "");
  EXPECT_EQ(advice("odom", "base_footprint", 0.5, 0.0, 1), "");
  EXPECT_NE(advice("odom", "", 0.5, 0.0, 1).find("child_frame_id on  is empty"), std::string::npos);
  EXPECT_NE(advice("odom", "base", 0.5, 0.0, 1).find("base, which tf does not know"), std::string::npos);
  EXPECT_NE(advice("odom", "odom", 0.5, 0.0, 1).find("does not move with the robot"), std::string::npos);
  EXPECT_NE(advice("odom", "base_link", 0.3, 0.4, 20).find("linear.y"), std::string::npos);
  EXPECT_EQ(advice("odom", "base_link", 0.3, 0.4, 19), "");   // for less than 20 messages
  EXPECT_EQ(advice("odom", "base_link", 0.5, 0.2, 20), "");   // less than half of what is ahead: it slips
  EXPECT_EQ(advice("odom", "base_link", 0.0, 0.09, 20), "");  // noise
}

}  // namespace
}  // namespace hidwa_local_planner
