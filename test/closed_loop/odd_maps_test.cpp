// SPDX-License-Identifier: BSD-3-Clause
// Outlines and maps that are not what the default is: an outline beside the robot's origin, fine and coarse cells, maps
// that are not square, that change their size or do not hold the robot, and unknown cells.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "support/naive_inflation.hpp"
#include "support/scene_loop.hpp"

namespace hidwa_local_planner::test {
namespace {

/// A free map of `width` x `height` [m] around the origin; the robot at (-1.5, 0) is to go to (1.5, 0) and face left.
Scene scene_of(double width, double height, double resolution) {
  Scene scene;
  scene.size_x = static_cast<int>(std::lround(width / resolution));
  scene.size_y = static_cast<int>(std::lround(height / resolution));
  scene.resolution = resolution;
  scene.origin_x = -0.5 * scene.size_x * resolution;
  scene.origin_y = -0.5 * scene.size_y * resolution;
  scene.costs.assign(static_cast<std::size_t>(scene.size_x * scene.size_y), cost::kFree);
  scene.outline = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};
  Situation& now = scene.situation;
  now.pose = {-1.5, 0.0, 0.0};
  now.time = 1.0;
  now.goal = {1.5, 0.0, 0.5 * M_PI};
  for (int k = 0; k <= 60; ++k) now.plan.push_back({-1.5 + 0.05 * k, 0.0, 0.0});
  now.plan.back() = now.goal;
  return scene;
}

void expect_arrival(const Course& course, const std::string& what) {
  EXPECT_TRUE(course.arrived) << what << ": " << course.problem;
  EXPECT_FALSE(course.touched) << what;
}

// A post beside the way, and the robot's origin 0.1 m behind its outline, before it, or to its left.
TEST(OddMaps, AnOutlineThatDoesNotHoldTheOriginDrives) {
  for (const Polygon& outline : {Polygon{{0.5, 0.2}, {0.1, 0.2}, {0.1, -0.2}, {0.5, -0.2}},
                                 Polygon{{-0.1, 0.2}, {-0.5, 0.2}, {-0.5, -0.2}, {-0.1, -0.2}},
                                 Polygon{{0.2, -0.1}, {-0.2, -0.1}, {-0.2, -0.5}, {0.2, -0.5}}}) {
    Scene scene = scene_of(6.0, 6.0, 0.05);
    scene.outline = outline;
    scene.fill(-0.1, 0.3, 0.1, 0.5);
    inflate(scene, 0.05, 0.8, 3.0);
    expect_arrival(drive_to_goal(scene, 40.0), "the first corner is at " + std::to_string(outline[0].x()));
  }
}

TEST(OddMaps, FineAndCoarseCellsDrive) {
  for (const double resolution : {0.02, 0.05, 0.2}) {
    Scene scene = scene_of(6.0, 6.0, resolution);
    scene.fill(-0.2, 0.5, 0.2, 0.9);
    inflate(scene, 0.2, 0.8, 3.0);
    expect_arrival(drive_to_goal(scene, 40.0), std::to_string(resolution));
  }
}

TEST(OddMaps, MapsThatAreNotSquareDrive) {
  for (const auto& [width, height] : {std::pair{10.0, 3.0}, std::pair{4.4, 12.0}, std::pair{4.5, 2.05}}) {
    Scene scene = scene_of(width, height, 0.05);
    expect_arrival(drive_to_goal(scene, 40.0), std::to_string(width));
  }
}

// Every second another size and another place, as a host does that reconfigures its costmap.
TEST(OddMaps, AMapThatIsResizedDrives) {
  Scene scene = scene_of(6.0, 6.0, 0.05);
  const Course course = drive_to_goal(scene, 40.0, [&scene](double time) {
    const int phase = static_cast<int>(time) % 4;
    const double width = phase == 1 ? 10.0 : 6.0, height = phase == 2 ? 4.4 : 6.0;
    const Scene other = scene_of(width, height, phase == 3 ? 0.1 : 0.05);
    scene.costs = other.costs;
    scene.size_x = other.size_x;
    scene.size_y = other.size_y;
    scene.resolution = other.resolution;
    scene.origin_x = other.origin_x;
    scene.origin_y = other.origin_y;
  });
  expect_arrival(course, "resized");
}

// It brakes, and says so; once the map holds it again it drives.
TEST(OddMaps, AMapThatDoesNotHoldTheRobotIsNamed) {
  Scene scene = scene_of(6.0, 6.0, 0.05);
  const double origin = scene.origin_x;
  const Course course =
      drive_to_goal(scene, 40.0, [&](double time) { scene.origin_x = time > 2.0 && time < 4.0 ? 20.0 : origin; });
  EXPECT_NE(course.problem.find("map"), std::string::npos) << course.problem;
  EXPECT_TRUE(course.arrived);
}

// All that is ahead is unknown: that is told, and no obstacle.
TEST(OddMaps, UnknownCellsAreNamed) {
  for (const double resolution : {0.02, 0.05, 0.2}) {
    Scene scene = scene_of(6.0, 6.0, resolution);
    scene.fill(0.0, -4.0, 4.0, 4.0, cost::kUnknown);
    const Course course = drive_to_goal(scene, 20.0);
    EXPECT_FALSE(course.touched);
    EXPECT_NE(course.problem.find("unknown"), std::string::npos) << course.problem;
    EXPECT_EQ(course.problem.find("obstacle"), std::string::npos) << course.problem;
    EXPECT_EQ(course.rejected_by.find("Collision"), std::string::npos) << course.rejected_by;
  }
}

// A wall is one, also where unknown cells lie behind it.
TEST(OddMaps, AWallBeforeUnknownCellsIsAnObstacle) {
  Scene scene = scene_of(6.0, 6.0, 0.05);
  scene.fill(0.0, -4.0, 4.0, 4.0, cost::kUnknown);
  scene.fill(0.0, -4.0, 0.1, 4.0);
  inflate(scene, 0.2, 0.8, 3.0);
  const Course course = drive_to_goal(scene, 20.0);
  EXPECT_NE(course.problem.find("nearest obstacle"), std::string::npos) << course.problem;
  EXPECT_EQ(course.rejected_by.find("Unknown"), std::string::npos) << course.rejected_by;
}

}  // namespace
}  // namespace hidwa_local_planner::test
