// SPDX-License-Identifier: BSD-3-Clause
#include "ros/message_throttle.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

TEST(MessageThrottle, AtOnceWhenNewThenOnceASecond) {
  MessageThrottle throttle;
  EXPECT_TRUE(throttle.due(10.0, "no plan"));
  EXPECT_FALSE(throttle.due(10.05, "no plan"));
  EXPECT_TRUE(throttle.due(10.1, "no odometry"));
  EXPECT_FALSE(throttle.due(11.0, "no odometry"));
  EXPECT_TRUE(throttle.due(11.1, "no odometry"));
}

TEST(MessageThrottle, FiguresMakeNoDifference) {
  MessageThrottle throttle;
  EXPECT_TRUE(throttle.due(10.0, "odometry is 0.6 s old"));
  EXPECT_FALSE(throttle.due(10.1, "odometry is 0.7 s old"));
}

TEST(MessageThrottle, EndsOnceAndBeginsAnew) {
  MessageThrottle throttle;
  EXPECT_FALSE(throttle.end());
  throttle.due(10.0, "no plan");
  EXPECT_TRUE(throttle.end());
  EXPECT_FALSE(throttle.end());
  EXPECT_TRUE(throttle.due(10.1, "no plan"));
}

}  // namespace
}  // namespace hidwa_local_planner
