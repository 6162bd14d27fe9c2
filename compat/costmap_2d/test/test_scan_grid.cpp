// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <costmap_2d/scan_grid.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace costmap_2d {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Area {
  double min_x = kInfinity, min_y = kInfinity, max_x = -kInfinity, max_y = -kInfinity;
  TouchedArea touched() { return {&min_x, &min_y, &max_x, &max_y}; }
};

geometry_msgs::Point point(double x, double y, double z = 0.2) {
  geometry_msgs::Point p;
  p.x = x;
  p.y = y;
  p.z = z;
  return p;
}

Observation seen(std::vector<geometry_msgs::Point> points) {
  Observation observation;
  observation.origin = point(1.025, 1.025);  // the centre of cell (20, 20)
  observation.points = std::move(points);
  return observation;
}

sensor_msgs::LaserScan fourBeams(float ahead, float left, float behind, float right) {
  sensor_msgs::LaserScan scan;
  scan.angle_increment = static_cast<float>(M_PI / 2);
  scan.range_min = 0.1f;
  scan.range_max = 5.0f;
  scan.ranges = {ahead, left, behind, right};
  return scan;
}

TEST(ScanGrid, ProjectsIntoTheFrame) {
  geometry_msgs::Transform pose;
  pose.translation.x = 1.0;
  pose.translation.z = 0.3;
  pose.rotation.z = pose.rotation.w = std::sqrt(0.5);  // turned left by a right angle
  const auto points = projectScan(fourBeams(2.0f, 1.0f, 0.05f, 5.0f), pose, {});
  ASSERT_EQ(points.size(), 2u);  // 0.05 is below range_min, 5.0 not below range_max
  EXPECT_NEAR(points[0].x, 1.0, 1e-6);
  EXPECT_NEAR(points[0].y, 2.0, 1e-6);
  EXPECT_NEAR(points[1].x, 0.0, 1e-6);
  EXPECT_NEAR(points[1].y, 0.0, 1e-6);
  EXPECT_NEAR(points[0].z, 0.3, 1e-6);
}

TEST(ScanGrid, InfiniteRangesOnlyWhereTheyAreValid) {
  geometry_msgs::Transform pose;
  pose.rotation.w = 1.0;
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  ScanFilter filter;
  EXPECT_TRUE(projectScan(fourBeams(inf, nan, -inf, inf), pose, filter).empty());
  filter.inf_is_valid = true;
  const auto points = projectScan(fourBeams(inf, nan, -inf, inf), pose, filter);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR(points[0].x, 5.0, 1e-3);
  EXPECT_NEAR(points[1].y, -5.0, 1e-3);
}

TEST(ScanGrid, HeightFilter) {
  geometry_msgs::Transform pose;
  pose.rotation.w = 1.0;
  ScanFilter filter;
  for (const auto& [z, expected] : {std::pair<double, std::size_t>{-0.01, 0}, {0.0, 1}, {2.0, 1}, {2.01, 0}}) {
    pose.translation.z = z;
    EXPECT_EQ(projectScan(fourBeams(1.0f, 9.0f, 9.0f, 9.0f), pose, filter).size(), expected) << z;
  }
}

TEST(ScanGrid, MarksWithinTheObstacleRange) {
  Costmap2D grid(80, 80, 0.05, 0.0, 0.0);
  Area area;
  // The third is beyond 2.5 m, the fourth too high, the fifth outside the map.
  markPoints(grid, seen({point(2.0, 1.0), point(1.0, 3.0), point(3.6, 1.025), point(1.5, 1.5, 2.1), point(-0.5, 1.0)}),
             2.0, area.touched());
  int count = 0;
  for (unsigned int i = 0; i < 80 * 80; ++i) count += grid.getCharMap()[i] == LETHAL_OBSTACLE;
  EXPECT_EQ(count, 2);
  EXPECT_EQ(grid.getCost(40, 20), LETHAL_OBSTACLE);
  EXPECT_EQ(grid.getCost(20, 60), LETHAL_OBSTACLE);
  EXPECT_DOUBLE_EQ(area.max_x, 2.0);
  EXPECT_DOUBLE_EQ(area.max_y, 3.0);
}

TEST(ScanGrid, ClearsAlongTheBeamUpToTheRaytraceRange) {
  Costmap2D grid(120, 80, 0.05, 0.0, 0.0, LETHAL_OBSTACLE);
  Area area;
  ASSERT_TRUE(clearBeams(grid, seen({point(5.5, 1.025)}), area.touched()));
  for (unsigned int y = 0; y < 80; ++y) {
    for (unsigned int x = 0; x < 120; ++x) {
      // From cell 20 on, 3.0 m are 60 cells.
      const bool freed = y == 20 && x >= 20 && x <= 80;
      ASSERT_EQ(grid.getCost(x, y), freed ? FREE_SPACE : LETHAL_OBSTACLE) << x << ", " << y;
    }
  }
  EXPECT_NEAR(area.min_x, 1.025, 1e-9);
  EXPECT_GE(area.max_x, 4.05);  // the far edge of cell 80
  EXPECT_LE(area.max_x, 4.1);
}

TEST(ScanGrid, FollowsABeamToTheMapsEdge) {
  Costmap2D grid(40, 40, 0.05, 0.0, 0.0, LETHAL_OBSTACLE);
  Area area;
  ASSERT_TRUE(clearBeams(grid, seen({point(3.025, 1.025), point(1.025, -4.0), point(-9.0, -9.0)}), area.touched()));
  EXPECT_EQ(grid.getCost(39, 20), FREE_SPACE);
  EXPECT_EQ(grid.getCost(20, 0), FREE_SPACE);
  EXPECT_EQ(grid.getCost(0, 0), FREE_SPACE);  // the diagonal
  EXPECT_EQ(grid.getCost(39, 39), LETHAL_OBSTACLE);
}

TEST(ScanGrid, ASensorOutsideClearsNothing) {
  Costmap2D grid(10, 10, 0.05, 0.0, 0.0, LETHAL_OBSTACLE);
  Area area;
  EXPECT_FALSE(clearBeams(grid, seen({point(0.2, 0.2)}), area.touched()));
  EXPECT_EQ(grid.getCost(4, 4), LETHAL_OBSTACLE);
}

TEST(ScanGrid, Merging) {
  Costmap2D target(4, 1, 1.0, 0.0, 0.0), source(4, 1, 1.0, 0.0, 0.0);
  const unsigned char to[] = {100, 100, NO_INFORMATION, 5}, from[] = {50, 200, 0, NO_INFORMATION};
  const auto load = [&] {
    std::copy(to, to + 4, target.getCharMap());
    std::copy(from, from + 4, source.getCharMap());
  };
  load();
  mergeMaximum(target, source, 0, 0, 4, 1);
  EXPECT_EQ(std::vector<int>(target.getCharMap(), target.getCharMap() + 4), (std::vector<int>{100, 200, 0, 5}));
  load();
  mergeOverwrite(target, source, 0, 0, 4, 1);
  EXPECT_EQ(std::vector<int>(target.getCharMap(), target.getCharMap() + 4), (std::vector<int>{50, 200, 0, 5}));
}

}  // namespace
}  // namespace costmap_2d
