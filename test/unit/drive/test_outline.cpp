// SPDX-License-Identifier: BSD-3-Clause
#include "drive/outline.hpp"

#include <gtest/gtest.h>

#include "hidwa_local_planner/core/footprint.hpp"

namespace hidwa_local_planner {
namespace drive {
namespace {

TEST(Outline, PaddingMovesEachCoordinateAwayFromZero) {
  const Polygon padded = padded_outline({{0.2, 0.1}, {-0.2, 0.1}, {-0.2, -0.1}, {0.0, -0.1}}, 0.01);
  const Polygon expected{{0.21, 0.11}, {-0.21, 0.11}, {-0.21, -0.11}, {0.0, -0.11}};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_TRUE(padded[i].isApprox(expected[i])) << i;
}

TEST(Outline, ARadiusGivesSixteenCornersWhichThePlannerTakesForACircle) {
  const Polygon plain = circle_outline(0.3, 0.0);
  ASSERT_EQ(plain.size(), 16u);
  for (const Point& corner : plain) EXPECT_NEAR(corner.norm(), 0.3, 1e-12);
  const Footprint planned = Footprint::from_outline(circle_outline(0.3, 0.01), 0.0);
  EXPECT_TRUE(planned.is_circle());
  EXPECT_NEAR(planned.radius(), 0.3 + 0.01 * std::sqrt(2.0), 1e-9);
}

}  // namespace
}  // namespace drive
}  // namespace hidwa_local_planner
