// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/footprint.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

Polygon round_outline(int corners, double radius) {
  Polygon outline;
  for (int i = 0; i < corners; ++i) {
    outline.emplace_back(radius * std::cos(2.0 * M_PI * i / corners),
                         radius * std::sin(2.0 * M_PI * i / corners));
  }
  return outline;
}

TEST(FootprintRadii, RectangleAroundTheOrigin) {
  const Footprint f(Polygon{{0.3, 0.2}, {-0.4, 0.2}, {-0.4, -0.2}, {0.3, -0.2}});
  EXPECT_DOUBLE_EQ(f.inscribed_radius(), 0.2);
  EXPECT_DOUBLE_EQ(f.circumscribed_radius(), std::hypot(0.4, 0.2));
  EXPECT_FALSE(f.is_circle());
  EXPECT_FALSE(f.empty());
}

TEST(FootprintRadii, EitherWayRound) {
  const Footprint f(Polygon{{0.3, -0.2}, {-0.4, -0.2}, {-0.4, 0.2}, {0.3, 0.2}});
  EXPECT_DOUBLE_EQ(f.inscribed_radius(), 0.2);
}

TEST(FootprintRadii, OriginOutsideHasNoInscribedCircle) {
  const Footprint f(Polygon{{0.3, 0.2}, {0.1, 0.2}, {0.1, -0.2}, {0.3, -0.2}});
  EXPECT_EQ(f.inscribed_radius(), 0.0);
  EXPECT_DOUBLE_EQ(f.circumscribed_radius(), std::hypot(0.3, 0.2));
}

TEST(FootprintRadii, NonConvexTakesItsDent) {
  // A dent from the front to x = 0.05.
  const Footprint f(Polygon{{0.3, 0.3}, {-0.3, 0.3}, {-0.3, -0.3}, {0.3, -0.3}, {0.05, 0.0}});
  // The dent's tip is nearest: its sides lead away from the origin.
  EXPECT_NEAR(f.inscribed_radius(), 0.05, 1e-12);
}

TEST(FootprintRadii, EmptyAndCircle) {
  EXPECT_TRUE(Footprint().empty());
  EXPECT_TRUE(Footprint::from_outline({}, 0.1).empty());
  const Footprint circle({}, 0.3);
  EXPECT_TRUE(circle.is_circle());
  EXPECT_EQ(circle.inscribed_radius(), 0.3);
  EXPECT_EQ(circle.circumscribed_radius(), 0.3);
}

TEST(FootprintCircle, TheHostsSixteenCornersAreACircle) {
  const Footprint f = Footprint::from_outline(round_outline(16, 0.3), 0.02);
  ASSERT_TRUE(f.is_circle());
  EXPECT_DOUBLE_EQ(f.radius(), 0.32);
}

TEST(FootprintCircle, PaddedCoordinateByCoordinateAsTheHostDoes) {
  Polygon outline = round_outline(16, 0.3);
  for (Point& p : outline) p += Point(std::copysign(0.01, p.x()), std::copysign(0.01, p.y()));
  const Footprint f = Footprint::from_outline(outline, 0.0);
  ASSERT_TRUE(f.is_circle());
  // The diagonal corners moved farthest: no corner may stick out.
  EXPECT_NEAR(f.radius(), 0.3 + 0.01 * std::sqrt(2.0), 1e-12);
}

TEST(FootprintCircle, FewOrUnevenCornersAreAPolygon) {
  EXPECT_FALSE(Footprint::from_outline(round_outline(8, 0.3), 0.0).is_circle());
  Polygon outline = round_outline(16, 0.3);
  outline[3] *= 1.05;
  EXPECT_FALSE(Footprint::from_outline(outline, 0.0).is_circle());
}

TEST(FootprintPadding, EverySideMovesOutwards) {
  for (const bool reversed : {false, true}) {
    Polygon outline{{0.3, 0.2}, {-0.4, 0.2}, {-0.4, -0.2}, {0.3, -0.2}};
    if (reversed) outline = Polygon(outline.rbegin(), outline.rend());
    const Footprint f = Footprint::from_outline(outline, 0.05);
    EXPECT_NEAR(f.inscribed_radius(), 0.25, 1e-12);
    EXPECT_NEAR(f.circumscribed_radius(), std::hypot(0.45, 0.25), 1e-12);
  }
}

TEST(FootprintPadding, ADentMovesOutwardsToo) {
  // An L: the inner corner at (0, 0) goes to (0.05, 0.05), the outer ones away from the body.
  const Footprint f(Polygon{{0.4, -0.4}, {0.4, 0.0}, {0.0, 0.0}, {0.0, 0.4}, {-0.4, 0.4}, {-0.4, -0.4}});
  const Polygon padded = f.padded(0.05).outline();
  EXPECT_NEAR((padded[2] - Point(0.05, 0.05)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((padded[1] - Point(0.45, 0.05)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((padded[5] - Point(-0.45, -0.45)).norm(), 0.0, 1e-12);
}

TEST(FootprintPadding, RepeatedCornersDoNoHarm) {
  const Footprint f = Footprint::from_outline(
      {{0.3, 0.2}, {0.3, 0.2}, {-0.4, 0.2}, {-0.4, -0.2}, {0.3, -0.2}, {0.3, 0.2}}, 0.1);
  ASSERT_EQ(f.outline().size(), 4u);
  EXPECT_NEAR(f.inscribed_radius(), 0.3, 1e-12);
}

TEST(FootprintPadding, NoneChangesNothing) {
  const Polygon outline{{0.3, 0.2}, {-0.4, 0.2}, {-0.4, -0.2}};
  const Footprint f = Footprint(outline).padded(0.0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(f.outline()[i], outline[i]);
}

}  // namespace
}  // namespace hidwa_local_planner
