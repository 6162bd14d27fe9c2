// SPDX-License-Identifier: BSD-3-Clause
// Which cycle `hidwa_replay --at` means.
#include "../lab/replay/moment.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace replay {
namespace {

// Records every 0.05 s for 60 s from `first` [s] on; those of the seconds 20 to 30 are missing.
MomentSearch search(const std::string& text, double first) {
  MomentSearch search(*moment_of(text));
  for (int k = 0; k <= 1200; ++k) {
    if (k <= 400 || k >= 600) search.see(first + 0.05 * k);
  }
  return search;
}

double found(const std::string& text, double first) { return search(text, first).found().value_or(-1.0); }

TEST(Moment, OfANumberWithOrWithoutRos) {
  EXPECT_EQ(moment_of("71.25")->seconds, 71.25);
  EXPECT_FALSE(moment_of("71.25")->ros_time);
  EXPECT_EQ(moment_of("ros:71.25")->seconds, 71.25);
  EXPECT_TRUE(moment_of("ros:71.25")->ros_time);
  for (const char* text : {"", "ros:", "noon", "71.2s", "nan", "inf", "ros:nan", "sim:3"})
    EXPECT_FALSE(moment_of(text)) << text;
}

TEST(Moment, SinceTheFirstRecordOrTheWallClock) {
  const double begin = 1606014000.5;  // a robot's
  EXPECT_NEAR(found("12.34", begin), begin + 12.35, 1e-6);
  EXPECT_NEAR(found("1606014012.84", begin), begin + 12.35, 1e-6);
  EXPECT_NEAR(found("ros:1606014012.84", begin), begin + 12.35, 1e-6);
  EXPECT_EQ(found("ros:12.34", begin), -1.0);
  EXPECT_EQ(search("1606014012.84", begin).remark(), "");
}

// A simulation's clock begins near 0, so that one number may be both.
TEST(Moment, OfASimulatedClock) {
  EXPECT_NEAR(found("50", 15.0), 65.0, 1e-9);
  EXPECT_NE(search("50", 15.0).remark().find("--at ros:50.000"), std::string::npos);
  EXPECT_NEAR(found("ros:50", 15.0), 50.0, 1e-9);
  EXPECT_EQ(search("ros:50", 15.0).remark(), "");
}

TEST(Moment, OfASimulatedClockThatOnlyTheRosTimeHits) {
  EXPECT_NEAR(found("70", 15.0), 70.0, 1e-9);  // the first record and 70 s is 85 s: the last is at 75 s
  EXPECT_EQ(search("70", 15.0).remark(), "");
}

TEST(Moment, WhereThereIsNoRecordTheTimesThatThereAreAreNamed) {
  for (const char* text : {"25", "ros:25000", "99", "-5"}) {
    const MomentSearch none = search(text, 1000.0);
    EXPECT_FALSE(none.found()) << text;
    EXPECT_NE(none.remark().find("0 to 60.000 s since the first record, which is ROS time 1000.000 to 1060.000"),
              std::string::npos)
        << none.remark();
  }
  EXPECT_NE(MomentSearch(*moment_of("1")).remark().find("record_cycles"), std::string::npos);
}

}  // namespace
}  // namespace replay
}  // namespace hidwa_local_planner
