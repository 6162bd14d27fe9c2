// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/ros/loop_time.hpp"

#include <gtest/gtest.h>

#include "hidwa_local_planner/ros/odometry_input.hpp"

namespace hidwa_local_planner {
namespace {

TEST(LoopTime, AStampIsAsLongAgoAsByTheOtherClock) {
  const LoopTime now{1000.0, ros::Time(40.0)};  // the system's clock was set back by 960 s
  EXPECT_EQ(now.of(ros::Time(39.5)), 999.5);
  EXPECT_EQ(now.of(ros::Time(41.0)), 1001.0);
  EXPECT_EQ(now.of(ros::Time()), 0.0);  // no time
}

TEST(LoopTime, WithASimulatedClockBothAreThat) {
  ros::Time::init();
  ros::Time::setNow(ros::Time(12.25));
  EXPECT_EQ(LoopTime::now().seconds, 12.25);
  EXPECT_EQ(LoopTime::now().of(ros::Time(0.1)), ros::Time(0.1).toSec());
  ros::Time::setNow(ros::Time(3.0));
  EXPECT_EQ(LoopTime::now().seconds, 3.0);
  ros::Time::shutdown();
}

// Odometry that was received before the clock was set is as old as it is.
TEST(LoopTime, AReadingIsAsOldAsItIsAfterTheClockWasSet) {
  nav_msgs::Odometry message;
  message.header.stamp = ros::Time(1000.0);
  OdometryInput input;
  input.receive(message, {1000.1, ros::Time(1000.1)});
  EXPECT_TRUE(input.read(1000.2, 0.5).velocity);
  message.header.stamp = ros::Time(39.9);  // 960.1 s back
  input.receive(message, {1000.2, ros::Time(40.1)});
  EXPECT_TRUE(input.read(1000.3, 0.5).velocity);   // 0.3 s old
  EXPECT_FALSE(input.read(1000.6, 0.5).velocity);  // 0.6 s
}

}  // namespace
}  // namespace hidwa_local_planner
