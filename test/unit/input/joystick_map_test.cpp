// SPDX-License-Identifier: BSD-3-Clause
#include "input/joystick_map.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace hidwa_local_planner::input {
namespace {

TEST(JoystickMap, PaperAtItsEdges) {
  EXPECT_EQ(map_axis(0.0, 0.1, 2.0, 1.0), 0.0);
  EXPECT_EQ(map_axis(0.1, 0.1, 2.0, 1.0), 0.0);  // |p| <= 0.1
  EXPECT_EQ(map_axis(-0.1, 0.1, 2.0, 1.0), 0.0);
  const double above = std::nextafter(0.1, 1.0);
  EXPECT_DOUBLE_EQ(map_axis(above, 0.1, 2.0, 1.0), 0.01);  // 0.1^2: the map jumps here
  EXPECT_DOUBLE_EQ(map_axis(-above, 0.1, 2.0, 1.0), -0.01);
  EXPECT_DOUBLE_EQ(map_axis(0.5, 0.1, 2.0, 1.0), 0.25);  // 0.5^2
  EXPECT_DOUBLE_EQ(map_axis(-0.5, 0.1, 2.0, 1.0), -0.25);
  EXPECT_EQ(map_axis(1.0, 0.1, 2.0, 1.0), 1.0);
  EXPECT_EQ(map_axis(-1.0, 0.1, 2.0, 1.0), -1.0);
}

TEST(JoystickMap, MaximumAndExponent) {
  EXPECT_DOUBLE_EQ(map_axis(0.5, 0.1, 2.0, 0.8), 0.2);     // 0.25 * 0.8
  EXPECT_DOUBLE_EQ(map_axis(-0.5, 0.1, 3.0, 2.0), -0.25);  // -0.125 * 2
  EXPECT_DOUBLE_EQ(map_axis(0.5, 0.1, 1.0, 1.0), 0.5);
  EXPECT_EQ(map_axis(0.5, 0.6, 1.0, 1.0), 0.0);
}

TEST(JoystickMap, BeyondFullScaleIsFullScale) {
  EXPECT_EQ(map_axis(1.00003, 0.1, 2.0, 1.0), 1.0);
  EXPECT_EQ(map_axis(-7.0, 0.1, 2.0, 0.5), -0.5);
}

TEST(JoystickMap, NotANumberIsNoDeflection) {
  EXPECT_EQ(map_axis(std::numeric_limits<double>::quiet_NaN(), 0.1, 2.0, 1.0), 0.0);
}

}  // namespace
}  // namespace hidwa_local_planner::input
