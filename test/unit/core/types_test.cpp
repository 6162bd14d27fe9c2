// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/types.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner {
namespace {

double slowly_wrapped(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * M_PI);
  return wrapped <= -M_PI ? M_PI : wrapped;
}

void expect_same_bits(double angle) {
  const double fast = wrap_angle(angle), slow = slowly_wrapped(angle);
  EXPECT_EQ(std::memcmp(&fast, &slow, sizeof(fast)), 0) << angle << ": " << fast << ", " << slow;
}

TEST(WrapAngle, GivesTheBitsOfTheRemainder) {
  for (int half = -7; half <= 7; ++half) {
    double below = half * M_PI, above = below;
    for (int k = 0; k < 20; ++k) {
      expect_same_bits(below);
      expect_same_bits(above);
      below = std::nextafter(below, -1e9);
      above = std::nextafter(above, 1e9);
    }
  }
  test::Random random(1);
  for (int k = 0; k < 100000; ++k) expect_same_bits(random.uniform(-25.0, 25.0));
  for (const double angle : {0.0, -0.0, 1e-300, -1e-300, 1e9, -1e18}) expect_same_bits(angle);
  EXPECT_TRUE(std::isnan(wrap_angle(NAN)));
  EXPECT_TRUE(std::isnan(wrap_angle(INFINITY)));
}

}  // namespace
}  // namespace hidwa_local_planner
