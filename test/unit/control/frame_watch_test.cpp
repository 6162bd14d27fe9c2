// SPDX-License-Identifier: BSD-3-Clause
#include "control/frame_watch.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner::control {
namespace {

TEST(FrameWatch, TheRobotsOwnFrameIsRefusedByName) {
  EXPECT_NE(fault_of_frames("base_link", "base_link").find("global_frame is base_link"), std::string::npos);
  EXPECT_NE(fault_of_frames("/robot_1/base_link", "robot_1/base_link"), "");  // tf, and tf2
  EXPECT_EQ(fault_of_frames("odom", "base_link"), "");
  EXPECT_EQ(fault_of_frames("map", "base_link"), "");
  EXPECT_EQ(fault_of_frames("", "base_link"), "");
}

// 0.5 m/s and 1 rad/s at 20 Hz. Its pose may be any, base_footprint's in base_link for example.
TEST(FrameWatch, APoseThatStaysWhileTheRobotDrivesIsNoticed) {
  for (const Twist2& velocity : {Twist2{0.5, 0.0}, Twist2{-0.5, 0.0}, Twist2{0.0, 1.0}, Twist2{0.0, -1.0}}) {
    FrameWatch watch;
    for (int i = 0; i < 40; ++i) watch.observe({0.1, 0.0, 0.0}, velocity, 0.05);
    EXPECT_FALSE(watch.stands_still());  // 39 periods since it came there: 0.975 m, 1.95 rad
    for (int i = 0; i < 2; ++i) watch.observe({0.1, 0.0, 0.0}, velocity, 0.05);
    EXPECT_TRUE(watch.stands_still());                // 41 periods: 1.025 m, 2.05 rad
    watch.observe({0.1, 1e-9, 0.0}, velocity, 0.05);  // any other pose ends it
    EXPECT_FALSE(watch.stands_still());
  }
}

TEST(FrameWatch, ARobotThatStandsIsNotNoticed) {
  FrameWatch watch;
  for (int i = 0; i < 100000; ++i) watch.observe({3.0, 4.0, 1.0}, {}, 0.05);
  EXPECT_FALSE(watch.stands_still());
}

}  // namespace
}  // namespace hidwa_local_planner::control
