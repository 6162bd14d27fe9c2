// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/footprint.h>
#include <gtest/gtest.h>

#include <cmath>

namespace costmap_2d {
namespace {

TEST(Footprint, PaddingGoesOutwardsOnEachAxisByItself) {
  std::vector<geometry_msgs::Point> footprint;
  ASSERT_TRUE(makeFootprintFromString("[[0.3, 0.2], [0.3, -0.2], [-0.1, 0.0]]", footprint));
  padFootprint(footprint, 0.01);
  EXPECT_DOUBLE_EQ(footprint[0].x, 0.31);
  EXPECT_DOUBLE_EQ(footprint[0].y, 0.21);
  EXPECT_DOUBLE_EQ(footprint[1].y, -0.21);
  EXPECT_DOUBLE_EQ(footprint[2].x, -0.11);
  EXPECT_DOUBLE_EQ(footprint[2].y, 0.0);  // on the axis: stays
}

TEST(Footprint, Radii) {
  std::vector<geometry_msgs::Point> footprint;
  ASSERT_TRUE(makeFootprintFromString("[[0.3, 0.2], [0.3, -0.2], [-0.1, -0.2], [-0.1, 0.2]]", footprint));
  double inscribed, circumscribed;
  calculateMinAndMaxDistances(footprint, inscribed, circumscribed);
  EXPECT_DOUBLE_EQ(inscribed, 0.1);
  EXPECT_DOUBLE_EQ(circumscribed, std::hypot(0.3, 0.2));
}

TEST(Footprint, CircleHasSixteenCorners) {
  const auto circle = makeFootprintFromRadius(0.3);
  ASSERT_EQ(circle.size(), 16u);
  double inscribed, circumscribed;
  calculateMinAndMaxDistances(circle, inscribed, circumscribed);
  EXPECT_NEAR(circumscribed, 0.3, 1e-12);
  EXPECT_NEAR(inscribed, 0.3 * std::cos(M_PI / 16), 1e-12);  // the middle of a side
}

TEST(Footprint, TurnedAndMoved) {
  std::vector<geometry_msgs::Point> footprint, moved;
  ASSERT_TRUE(makeFootprintFromString("[[1, 0], [0, 1], [-1, 0]]", footprint));
  transformFootprint(2.0, 3.0, M_PI / 2, footprint, moved);
  EXPECT_NEAR(moved[0].x, 2.0, 1e-12);  // (1, 0) turned left is (0, 1)
  EXPECT_NEAR(moved[0].y, 4.0, 1e-12);
}

TEST(Footprint, RefusesWhatIsNoPolygon) {
  std::vector<geometry_msgs::Point> footprint;
  for (const char* text : {"", "[]", "[[0, 0], [1, 1]]", "[[0, 0], [1], [2, 2]]", "[[0, 0], [1, a], [2, 2]]", "[["}) {
    EXPECT_FALSE(makeFootprintFromString(text, footprint)) << text;
  }
  XmlRpc::XmlRpcValue number(1.0);
  EXPECT_THROW(makeFootprintFromXMLRPC(number, "/robot/footprint"), std::runtime_error);
}

}  // namespace
}  // namespace costmap_2d
