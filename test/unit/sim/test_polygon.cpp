// SPDX-License-Identifier: BSD-3-Clause
#include "sim/polygon.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace sim {
namespace {

const Polygon kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
// An L: the unit square [0, 2] x [0, 2] without [1, 2] x [1, 2].
const Polygon kHook{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

TEST(Polygon, TransformTurnsThenMoves) {
  // (1, 0) turned by 90 degrees is (0, 1); moved by (2, 3): (2, 4).
  const Polygon p = transformed({{1, 0}}, {2, 3, M_PI / 2});
  EXPECT_NEAR(p[0].x(), 2.0, 1e-12);
  EXPECT_NEAR(p[0].y(), 4.0, 1e-12);
}

TEST(Polygon, ContainsKnowsHollows) {
  EXPECT_TRUE(contains(kHook, {0.5, 1.5}));
  EXPECT_TRUE(contains(kHook, {1.5, 0.5}));
  EXPECT_FALSE(contains(kHook, {1.5, 1.5}));
  EXPECT_FALSE(contains(kHook, {-0.1, 0.5}));
}

TEST(Polygon, TouchCasesOneByOne) {
  const auto at = [](double x, double y) { return transformed(kSquare, {x, y, 0}); };
  EXPECT_TRUE(touch(kSquare, at(0.5, 0.5)));     // overlap
  EXPECT_TRUE(touch(kSquare, at(1.0, 0.3)));     // a common piece of border
  EXPECT_TRUE(touch(kSquare, at(1.0, 1.0)));     // a common corner
  EXPECT_FALSE(touch(kSquare, at(1.001, 0.0)));  // a gap of 1 mm
  EXPECT_FALSE(touch(kHook, at(1.001, 1.001)));  // within the hollow
  const Polygon inner{{0.2, 0.2}, {0.8, 0.2}, {0.5, 0.8}};
  EXPECT_TRUE(touch(kSquare, inner));  // one inside the other, no borders meeting
  EXPECT_TRUE(touch(inner, kSquare));
}

TEST(Polygon, CircleLiesOnItsRadius) {
  const Polygon circle = circle_polygon(0.3, 16);
  EXPECT_EQ(circle.size(), 16u);
  EXPECT_NEAR(circumscribed_radius(circle), 0.3, 1e-12);
}

TEST(Pose, ComposeWithInverseIsIdentity) {
  const Pose pose{1.0, -2.0, 2.5};
  for (const Pose& p : {compose(pose, inverse(pose)), compose(inverse(pose), pose)}) {
    EXPECT_NEAR(p.x, 0.0, 1e-12);
    EXPECT_NEAR(p.y, 0.0, 1e-12);
    EXPECT_NEAR(p.theta, 0.0, 1e-12);
  }
}

TEST(Pose, AnglesAreBroughtIntoOneTurn) {
  EXPECT_NEAR(normalized(3.0 * M_PI), M_PI, 1e-12);
  EXPECT_DOUBLE_EQ(normalized(-M_PI), M_PI);
  EXPECT_NEAR(normalized(-1.5 * M_PI), 0.5 * M_PI, 1e-12);
}

}  // namespace
}  // namespace sim
}  // namespace hidwa_local_planner
