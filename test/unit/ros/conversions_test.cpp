// SPDX-License-Identifier: BSD-3-Clause
#include "ros/conversions.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace {

TEST(Conversions, PosesThereAndBack) {
  for (double yaw = -3.1; yaw < 3.14; yaw += 0.1) {
    const Pose2 back = to_pose(to_message(Pose2{1.5, -2.5, yaw}));
    EXPECT_DOUBLE_EQ(back.x, 1.5);
    EXPECT_DOUBLE_EQ(back.y, -2.5);
    EXPECT_NEAR(back.theta, yaw, 1e-12);
  }
}

TEST(Conversions, YawNeedsNoUnitQuaternion) {
  geometry_msgs::Quaternion q;  // all zero, as some planners leave it
  EXPECT_EQ(yaw_of(q), 0.0);
  q.z = 3.0 * std::sin(0.35);
  q.w = 3.0 * std::cos(0.35);
  EXPECT_NEAR(yaw_of(q), 0.7, 1e-12);
}

TEST(Conversions, TransformsUndoThemselves) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> metre(-50.0, 50.0);
  std::uniform_real_distribution<double> turn(-M_PI, M_PI);
  for (int i = 0; i < 1000; ++i) {
    const FrameTransform transform{{metre(random), metre(random), turn(random)}};
    const Pose2 pose{metre(random), metre(random), turn(random)};
    const Pose2 back = transform.apply_inverse(transform.apply(pose));
    EXPECT_NEAR(back.x, pose.x, 1e-9);
    EXPECT_NEAR(back.y, pose.y, 1e-9);
    EXPECT_NEAR(wrap_angle(back.theta - pose.theta), 0.0, 1e-9);
  }
}

TEST(Conversions, ATransformByHand) {
  // Turned left by 90 degrees and moved to (1, 2): (3, 0) becomes (1, 2 + 3).
  const Pose2 moved = FrameTransform{{1.0, 2.0, M_PI / 2}}.apply({3.0, 0.0, 0.0});
  EXPECT_NEAR(moved.x, 1.0, 1e-12);
  EXPECT_NEAR(moved.y, 5.0, 1e-12);
  EXPECT_NEAR(moved.theta, M_PI / 2, 1e-12);
}

TEST(Conversions, TwistsThereAndBack) { EXPECT_EQ(to_twist(to_message(Twist2{0.3, -0.7})), (Twist2{0.3, -0.7})); }

TEST(Conversions, TheGridSeesTheCostmapsCells) {
  costmap_2d::Costmap2D costmap(30, 20, 0.1, -1.0, 2.0);
  costmap.setCost(7, 3, 254);
  const GridView grid = view_of(costmap);
  ASSERT_TRUE(grid.valid());
  EXPECT_EQ(grid.size_x, 30);
  EXPECT_EQ(grid.size_y, 20);
  EXPECT_EQ(grid.at({7, 3}), 254);
  // Cell (7, 3) spans x from -1.0 + 0.7 and y from 2.0 + 0.3.
  const Cell cell = grid.cell_at(-0.25, 2.35);
  EXPECT_EQ(cell.i, 7);
  EXPECT_EQ(cell.j, 3);
}

}  // namespace
}  // namespace hidwa_local_planner
