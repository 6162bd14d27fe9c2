// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "input/stick_reading.hpp"

namespace hidwa_local_planner::input {
namespace {

TEST(JoystickMap, PaperAtItsEdges) {
  struct Row {
    double deflection, dead_zone, exponent, maximum, mapped;
  };
  const double above = std::nextafter(0.1, 1.0);
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  const Row rows[] = {
      {0.0, 0.1, 2.0, 1.0, 0.0},        // centred
      {0.1, 0.1, 2.0, 1.0, 0.0},        // |p| <= 0.1
      {above, 0.1, 2.0, 1.0, 0.01},     // 0.1^2: the map jumps here
      {0.5, 0.1, 2.0, 1.0, 0.25},       // 0.5^2
      {1.0, 0.1, 2.0, 1.0, 1.0},        // full scale
      {0.5, 0.1, 2.0, 0.8, 0.2},        // 0.5^2 * 0.8
      {0.5, 0.1, 3.0, 2.0, 0.25},       // 0.5^3 * 2
      {0.5, 0.1, 1.0, 1.0, 0.5},        // 0.5^1
      {0.5, 0.6, 1.0, 1.0, 0.0},        // |p| <= 0.6
      {1.00003, 0.1, 2.0, 1.0, 1.0},    // beyond full scale is full scale
      {7.0, 0.1, 2.0, 0.5, 0.5},        // however far
      {no_number, 0.1, 2.0, 1.0, 0.0},  // no deflection
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.deflection);
    EXPECT_DOUBLE_EQ(map_axis(row.deflection, row.dead_zone, row.exponent, row.maximum), row.mapped);
    EXPECT_DOUBLE_EQ(map_axis(-row.deflection, row.dead_zone, row.exponent, row.maximum), -row.mapped);
  }
}

}  // namespace
}  // namespace hidwa_local_planner::input
