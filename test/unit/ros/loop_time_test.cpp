// SPDX-License-Identifier: BSD-3-Clause
#include "ros/loop_time.hpp"

#include <gtest/gtest.h>

#include "ros/odometry_input.hpp"

namespace hidwa_local_planner {
namespace {

TEST(LoopTime, AStampIsAsLongAgoAsByTheOtherClock) {
  const LoopTime now{1000.0, ros::Time(40.0)};  // the system's clock was set back by 960 s
  EXPECT_EQ(now.of(ros::Time(39.5)), 999.5);
  EXPECT_EQ(now.of(ros::Time(41.0)), 1001.0);
  EXPECT_EQ(now.of(ros::Time()), 0.0);  // no time
}

TEST(LoopTime, UntilTheClockIsSetBothAreEqual) {
  ClockSettings settings;
  // It is 7 s ahead of the steady one, which is read 20 ns before it and 30 ns after it; the second time it takes 50 ms
  // from the first reading to the system's clock, and the third time from that to the second reading.
  EXPECT_EQ(settings.observe(500, 7000000520, 550), 0);
  EXPECT_EQ(settings.observe(1000, 7050001000, 50001050), 0);
  EXPECT_EQ(settings.observe(60000000, 7060000020, 110000000), 0);
  EXPECT_EQ(settings.observe(120000000, 7120000010, 120000020), 0);
}

TEST(LoopTime, ASettingIsToldAndEqualStampsStayEqual) {
  ClockSettings settings;
  settings.observe(1000, 5000000000, 1050);  // [ns]
  const std::int64_t back = settings.observe(2000, 3000001000, 2050);
  EXPECT_GE(back, 2000000000 - 50);
  EXPECT_LE(back, 2000000000 + 50);
  const double ahead = 1e-9 * static_cast<double>(back);
  for (int k = 1; k < 1000; ++k) {
    const std::int64_t moment = 12345678 * static_cast<std::int64_t>(k);
    EXPECT_EQ(settings.observe(2000 + moment, 3000001000 + moment, 2050 + moment), back) << k;
    ros::Time stamp;
    stamp.fromNSec(static_cast<std::uint64_t>(3000001000 + moment));
    const LoopTime now{stamp.toSec() + ahead, stamp, ahead};
    EXPECT_EQ(now.of(ros::Time(2.5)), 2.5 + ahead) << k;  // whenever it is heard again
  }
}

TEST(LoopTime, TheSystemsClockCountsWhileNobodySetsIt) {
  ros::Time::init();
  const LoopTime first = LoopTime::now(), second = LoopTime::now();
  EXPECT_EQ(first.of(ros::Time(1.5)), second.of(ros::Time(1.5)));
  EXPECT_LE(first.seconds, second.seconds);
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
