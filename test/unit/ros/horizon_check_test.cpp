// SPDX-License-Identifier: BSD-3-Clause
#include "ros/horizon_check.hpp"

#include <gtest/gtest.h>

#include "core/motion/velocity_limits.hpp"

namespace hidwa_local_planner {
namespace {

std::vector<std::string> complaints_of(const Parameters& p, double map_width, double map_height, double radius) {
  return horizon_complaints(p, VelocityLimits::from(p).x, map_width, map_height, radius);
}

TEST(HorizonCheck, TheDefaultsFitAFourMetreMap) {
  // 0.5 x 1.85 + 0.30 = 1.225 m <= 2 m; 0.5 / 2.5 + 0.1 = 0.3 s <= 1.85 s
  EXPECT_TRUE(complaints_of(Parameters(), 4.0, 4.0, 0.30).empty());
  EXPECT_TRUE(complaints_of(Parameters(), 2.46, 2.46, 0.30).empty());
}

TEST(HorizonCheck, ASmallMapIsReported) {
  const auto complaints = complaints_of(Parameters(), 4.0, 2.2, 0.30);
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_NE(complaints[0].find("reaches 1.10 m"), std::string::npos) << complaints[0];
  EXPECT_NE(complaints[0].find("1.2"), std::string::npos) << complaints[0];
}

TEST(HorizonCheck, AShortHorizonIsReported) {
  Parameters p;
  p.sim_time = 0.5;
  p.acc_lim_x = 1.0;  // 0.5 / 1.0 + 0.1 = 0.6 s
  const auto complaints = complaints_of(p, 4.0, 4.0, 0.30);
  ASSERT_EQ(complaints.size(), 1u);
  EXPECT_NE(complaints[0].find("0.60 s"), std::string::npos) << complaints[0];
}

TEST(HorizonCheck, ReverseCountsAsWell) {
  Parameters p;
  p.min_vel_x = -1.0;  // 1.0 x 1.85 + 0.3 = 2.15 m
  EXPECT_EQ(complaints_of(p, 4.2, 4.2, 0.30).size(), 1u);
}

}  // namespace
}  // namespace hidwa_local_planner
