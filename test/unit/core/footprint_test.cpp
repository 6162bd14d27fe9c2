// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/util/outline.hpp"
#include "support/naive_padding.hpp"
#include "support/random_scene.hpp"
#include "support/round_outline.hpp"

namespace hidwa_local_planner {
namespace {

using test::round_outline;

struct Radii {
  const char* of;
  Polygon outline;
  double inscribed, circumscribed;  // [m]
};

TEST(FootprintRadii, OfPolygons) {
  for (const Radii& radii : {
           Radii{"a rectangle", {{0.3, 0.2}, {-0.4, 0.2}, {-0.4, -0.2}, {0.3, -0.2}}, 0.2, std::hypot(0.4, 0.2)},
           Radii{
               "the other way round", {{0.3, -0.2}, {-0.4, -0.2}, {-0.4, 0.2}, {0.3, 0.2}}, 0.2, std::hypot(0.4, 0.2)},
           Radii{
               "the origin is outside", {{0.3, 0.2}, {0.1, 0.2}, {0.1, -0.2}, {0.3, -0.2}}, 0.0, std::hypot(0.3, 0.2)},
           // Its sides lead away from the origin: its tip is nearest.
           Radii{"a dent from the front to x = 0.05",
                 {{0.3, 0.3}, {-0.3, 0.3}, {-0.3, -0.3}, {0.3, -0.3}, {0.05, 0.0}},
                 0.05,
                 std::hypot(0.3, 0.3)},
       }) {
    const Footprint footprint(radii.outline);
    EXPECT_NEAR(footprint.inscribed_radius(), radii.inscribed, 1e-12) << radii.of;
    EXPECT_NEAR(footprint.circumscribed_radius(), radii.circumscribed, 1e-12) << radii.of;
  }
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
  const Footprint f = Footprint::from_outline(round_outline(0.3), 0.02);
  ASSERT_TRUE(f.is_circle());
  EXPECT_DOUBLE_EQ(f.radius(), 0.32);
}

TEST(FootprintCircle, PaddedCoordinateByCoordinateAsTheHostDoes) {
  Polygon outline = round_outline(0.3);
  for (Point& p : outline) p += Point(std::copysign(0.01, p.x()), std::copysign(0.01, p.y()));
  const Footprint f = Footprint::from_outline(outline, 0.0);
  ASSERT_TRUE(f.is_circle());
  // The diagonal corners moved farthest: no corner may stick out.
  EXPECT_NEAR(f.radius(), 0.3 + 0.01 * std::sqrt(2.0), 1e-12);
}

TEST(FootprintCircle, FewOrUnevenCornersAreAPolygon) {
  EXPECT_FALSE(Footprint::from_outline(round_outline(0.3, 8), 0.0).is_circle());
  Polygon outline = round_outline(0.3);
  outline[3] *= 1.05;
  EXPECT_FALSE(Footprint::from_outline(outline, 0.0).is_circle());
}

// The outline goes once around the point, or not at all.
bool inside(const Polygon& outline, const Point& p) {
  double turned = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point a = outline[i] - p, b = outline[(i + 1) % outline.size()] - p;
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(turned) > M_PI;
}

// Along each edge in small steps.
double naive_distance(const Polygon& outline, const Point& point) {
  constexpr int kSteps = 2000;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point a = outline[i] - point, b = outline[(i + 1) % outline.size()] - point;
    for (int k = 0; k <= kSteps; ++k) nearest = std::min(nearest, (a + (b - a) * k / kSteps).norm());
  }
  return inside(outline, point) ? -nearest : nearest;
}

TEST(FootprintDistance, IsThatToTheNearestPlaceOfAnyEdge) {
  test::Random random(12);
  int within = 0;
  for (int k = 0; k < 300; ++k) {
    Polygon outline = random.chance(0.5) ? test::random_star_outline(random) : test::random_convex_outline(random);
    if (random.chance(0.5)) std::reverse(outline.begin(), outline.end());
    const double most = random.pick({0.3, 1.0});
    const double x = random.uniform(-most, most), y = random.uniform(-most, most);
    const Point point(x, y);
    const double expected = naive_distance(outline, point), found = Footprint(outline).distance_to(point);
    // Off by no more than half a step, of edges no longer than 2 m.
    ASSERT_NEAR(found, expected, 0.5e-3) << k;
    within += found < 0.0;
  }
  EXPECT_GT(within, 60);
  EXPECT_DOUBLE_EQ(Footprint({}, 0.3).distance_to({0.3, 0.4}), 0.2);
  // On the corner, beside it, and with a corner twice.
  const Footprint square({{0.2, 0.2}, {-0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}});
  EXPECT_DOUBLE_EQ(square.distance_to({0.2, 0.2}), 0.0);
  EXPECT_DOUBLE_EQ(square.distance_to({0.5, 0.6}), 0.5);  // (0.3, 0.4) from the corner
  EXPECT_DOUBLE_EQ(square.distance_to({0.0, 0.15}), -0.05);
}

TEST(FootprintPadding, RepeatedCornersDoNoHarm) {
  const Footprint f =
      Footprint::from_outline({{0.3, 0.2}, {0.3, 0.2}, {-0.4, 0.2}, {-0.4, -0.2}, {0.3, -0.2}, {0.3, 0.2}}, 0.1);
  ASSERT_EQ(f.outline().size(), 4u);
  EXPECT_NEAR(f.inscribed_radius(), 0.3, 1e-12);
}

TEST(FootprintPadding, NoneChangesNothing) {
  const Polygon outline{{0.3, 0.2}, {-0.4, 0.2}, {-0.4, -0.2}};
  const Footprint f = Footprint(outline).padded(0.0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(f.outline()[i], outline[i]);
}

// Everything within `padding` of the outline, seen at 50 points of each side in 32 directions.
void expect_all_within(const Polygon& outline, double padding, const Polygon& padded) {
  const double reach = padding * (1.0 - 1e-6);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &a = outline[i], &b = outline[(i + 1) % outline.size()];
    for (int k = 0; k < 50; ++k) {
      for (int direction = 0; direction < 32; ++direction) {
        const double angle = 2.0 * M_PI * direction / 32;
        const Point p = a + k / 50.0 * (b - a) + reach * Point(std::cos(angle), std::sin(angle));
        ASSERT_TRUE(inside(padded, p)) << "side " << i << ", " << p.transpose();
      }
    }
  }
}

bool has_corner(const Polygon& outline, const Point& corner) {
  return std::any_of(outline.begin(), outline.end(),
                     [&](const Point& found) { return (found - corner).norm() < 1e-9; });
}

Polygon padded(const Polygon& outline, double padding) { return Footprint::from_outline(outline, padding).outline(); }

TEST(FootprintPadding, SharpCornersGetItInFull) {
  for (const double half : {1.0, 5.0, 10.0, 20.0, 29.0}) {  // half the angle at the tip (1, 0) [degrees]
    const double slope = std::tan(half * M_PI / 180.0);
    const Polygon outline{{1.0, 0.0}, {0.0, slope}, {0.0, -slope}};
    const Polygon result = padded(outline, 0.05);
    expect_all_within(outline, 0.05, result);
    for (const Point& corner : result) {
      EXPECT_LE(corner.x(), 1.05 + 1e-12) << half;  // the tip is cut off 0.05 m away
      double nearest = std::numeric_limits<double>::infinity();
      for (const Point& old : outline) nearest = std::min(nearest, (corner - old).norm());
      EXPECT_LE(nearest, 0.1 + 1e-12);
    }
  }
}

TEST(FootprintPadding, TwoPointsBecomeARectangle) {
  const Footprint f = Footprint::from_outline({{-0.3, 0.0}, {0.2, 0.0}}, 0.05);
  ASSERT_EQ(f.outline().size(), 4u);
  for (const Point& corner : {Point(-0.35, -0.05), Point(-0.35, 0.05), Point(0.25, 0.05), Point(0.25, -0.05)}) {
    EXPECT_TRUE(has_corner(f.outline(), corner)) << corner.transpose();
  }
  EXPECT_NEAR(f.inscribed_radius(), 0.05, 1e-12);
  EXPECT_EQ(f.sides().size(), 4u);  // convex
  EXPECT_EQ(f.fault(), nullptr);
  // Aslant, more points on the line, back and forth: the same.
  for (const Polygon& line : {Polygon{{-0.3, -0.3}, {0.2, 0.2}}, Polygon{{-0.3, -0.3}, {0.2, 0.2}, {0.0, 0.0}},
                              Polygon{{0.0, 0.0}, {0.1, 0.1}, {-0.3, -0.3}, {0.05, 0.05}, {0.2, 0.2}}}) {
    expect_all_within({{-0.3, -0.3}, {0.2, 0.2}}, 0.05, padded(line, 0.05));
    EXPECT_EQ(padded(line, 0.05).size(), 4u);
    // Half of 0.5 sqrt(2) + 2 * 0.05 along, 2 * 0.05 across: the farthest corner from (-0.05, -0.05).
    for (const Point& corner : padded(line, 0.05)) {
      EXPECT_NEAR((corner - Point(-0.05, -0.05)).norm(), std::hypot(0.25 * std::sqrt(2.0) + 0.05, 0.05), 1e-12);
    }
  }
}

TEST(FootprintPadding, OnePointBecomesASquare) {
  const Polygon square = padded({{0.1, 0.2}}, 0.05);
  ASSERT_EQ(square.size(), 4u);
  expect_all_within({{0.1, 0.2}}, 0.05, square);
}

struct Padding {
  const char* of;
  const Polygon& outline;
  double padding;  // [m]
  std::size_t corners;
};

// What is filled has the four corners of the convex hull.
TEST(FootprintPadding, ADentThatItClosesIsFilled) {
  const Polygon slotted{{0.3, 0.3},   {-0.3, 0.3},  {-0.3, -0.3}, {0.3, -0.3},
                        {0.3, -0.03}, {0.0, -0.03}, {0.0, 0.03},  {0.3, 0.03}};
  const Polygon bottle{{0.3, 0.3},   {-0.3, 0.3},   {-0.3, -0.3}, {0.3, -0.3}, {0.3, -0.02}, {0.1, -0.02},
                       {0.1, -0.15}, {-0.2, -0.15}, {-0.2, 0.15}, {0.1, 0.15}, {0.1, 0.02},  {0.3, 0.02}};
  const Polygon cut{{0.3, 0.3}, {-0.3, 0.3}, {-0.3, -0.3}, {0.3, -0.3}, {0.3, -0.01}, {-0.2, 0.0}, {0.3, 0.01}};
  const Polygon bow_tie{{0.3, 0.3}, {-0.3, -0.3}, {0.3, -0.3}, {-0.3, 0.3}};
  for (const Padding& row : {Padding{"a slot 0.06 m wide stays open", slotted, 0.02, 8},
                             Padding{"a slot 0.06 m wide closes", slotted, 0.04, 4},
                             Padding{"the neck of a bottle, 0.04 m wide, stays open", bottle, 0.01, 12},
                             Padding{"the neck closes, though no side vanishes", bottle, 0.03, 4},
                             Padding{"the sides of a sharp dent meet far outside once moved", cut, 0.02, 4},
                             Padding{"a bow tie crosses itself", bow_tie, 0.02, 4}}) {
    SCOPED_TRACE(row.of);
    const Polygon result = padded(row.outline, row.padding);
    EXPECT_EQ(result.size(), row.corners);
    expect_all_within(row.outline, row.padding, result);
  }
  EXPECT_FALSE(inside(padded(slotted, 0.02), {0.25, 0.0}));
  EXPECT_NEAR(Footprint(padded(slotted, 0.04)).circumscribed_radius(), 0.34 * std::sqrt(2.0), 1e-12);
}

// Random outlines, sharp and dented, either way round: nothing within the padding is left out, and the slow twin makes
// the same of them.
TEST(FootprintPadding, RandomOutlines) {
  test::Random random(11);
  int sharp = 0, filled = 0;
  for (int k = 0; k < 600; ++k) {
    const bool dented = random.chance(0.5);
    Polygon outline = dented ? test::random_star_outline(random) : test::random_convex_outline(random);
    for (std::size_t i = 0; dented && i < outline.size(); i += 2) outline[i] *= random.uniform(0.1, 0.5);
    if (random.chance(0.5)) std::reverse(outline.begin(), outline.end());
    const double padding = random.uniform(0.005, 0.3);
    const Polygon result = Footprint(outline).padded(padding).outline();
    SCOPED_TRACE(k);
    expect_all_within(outline, padding, result);
    if (testing::Test::HasFatalFailure()) return;
    sharp += result.size() > outline.size();
    filled += result.size() < outline.size();
    const Polygon twin = test::naive_padded({outline, 0.0}, padding).corners;
    ASSERT_EQ(result.size(), twin.size());
    for (const Point& corner : result) EXPECT_TRUE(has_corner(twin, corner)) << corner.transpose();
  }
  EXPECT_GE(sharp, 50);
  EXPECT_GE(filled, 5);
}

TEST(FootprintFault, NamesTheThingAndTheRemedy) {
  const auto fault = [](const Polygon& outline, double padding) {
    const char* text = Footprint::from_outline(outline, padding).fault();
    return std::string(text != nullptr ? text : "");
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(fault({{0.3, 0.2}, {-0.3, 0.2}, {0.0, -0.2}}, 0.0), "");
  EXPECT_EQ(fault(round_outline(0.3), 0.1), "");
  EXPECT_NE(fault({}, 0.1).find("robot_radius"), std::string::npos);
  EXPECT_NE(fault({{0.3, 0.2}, {nan, 0.2}, {0.0, -0.2}}, 0.1).find("not a number"), std::string::npos);
  EXPECT_NE(fault({{0.3, 0.2}, {-inf, 0.2}, {0.0, -0.2}}, 0.1).find("not a number"), std::string::npos);
  Polygon round = round_outline(0.3);
  round[5].x() = nan;
  EXPECT_NE(fault(round, 0.0).find("not a number"), std::string::npos);
  for (const double far : {21.0, 100.0, 1e300}) {
    EXPECT_NE(fault({{far, 0.0}, {0.0, far}, {0.0, 0.0}}, 0.1).find("20 m"), std::string::npos) << far;
    EXPECT_NE(fault(round_outline(far), 0.1).find("20 m"), std::string::npos) << far;
  }
  EXPECT_NE(fault({{0.3, 0.0}, {-0.3, 0.0}}, 0.0).find("footprint_padding"), std::string::npos);
  EXPECT_EQ(fault({{0.3, 0.0}, {-0.3, 0.0}}, 0.01), "");
}

TEST(ConvexHull, CounterClockwiseWithoutStraightCorners) {
  const Polygon hull = convex_hull({{0, 0}, {1, 0}, {0.5, 0}, {1, 1}, {0, 1}, {0.5, 0.5}, {0, 0.5}, {0, 0}, {1, 1}});
  const Polygon expected{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(hull, expected);
}

TEST(ConvexHull, OfALineItsEndsOfAPointThePoint) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_EQ(convex_hull({{1, 2}, {1, 2}, {1, 2}}), (Polygon{{1, 2}}));
  EXPECT_EQ(convex_hull({{0, 0}, {1, 1}, {2, 2}}), (Polygon{{0, 0}, {2, 2}}));
}

}  // namespace
}  // namespace hidwa_local_planner
