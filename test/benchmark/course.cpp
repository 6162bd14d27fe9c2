// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/course.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner::test {
namespace {

// The polyline in steps of Course::kSpacing. A path's corners are those of its lattice: a heading is that of
// the chord between the poses 0.3 m before and after.
std::vector<Pose2> paced(const std::vector<Point>& corners) {
  std::vector<Pose2> path;
  double due = 0.0;  // to the next pose [m]
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Point step = corners[i] - corners[i - 1];
    const double length = step.norm();
    for (; due < length; due += Course::kSpacing) {
      const Point p = corners[i - 1] + step * (due / length);
      path.push_back({p.x(), p.y(), 0.0});
    }
    due -= length;
  }
  constexpr std::size_t kChord = 6;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Pose2& from = path[i - std::min(i, kChord)];
    const Pose2& to = path[std::min(i + kChord, path.size() - 1)];
    path[i].theta = std::atan2(to.y - from.y, to.x - from.x);
  }
  return path;
}

}  // namespace

Course open_corridor(Random& random) {
  const double heading = random.uniform(-M_PI, M_PI);
  const double half_width = random.uniform(1.0, 1.5);
  const Point along(std::cos(heading), std::sin(heading));
  const Point left(-along.y(), along.x());
  constexpr double kLength = 20.0;  // [m]
  Course course;
  for (double at = 0.0; at < kLength; at += 0.5 * Course::kSpacing) {
    for (const double side : {-half_width, half_width}) course.obstacles.push_back(at * along + side * left);
  }
  course.path = paced({Point(0.0, 0.0), kLength * along});
  course.first = course.path.size() / 2;
  course.last = course.first + 20;
  return course;
}

Course barn_course(const sim::BarnWorld& world) {
  Course course;
  for (const Point& centre : world.cylinders) {
    for (const double dx : {-0.05, 0.0, 0.05}) {
      for (const double dy : {-0.05, 0.0, 0.05}) course.obstacles.push_back(centre + Point(dx, dy));
    }
  }
  std::vector<Point> corners{{-2.25, 3.0}};
  for (const Point& p : world.path) {
    if (p != corners.back()) corners.push_back(p);
  }
  corners.push_back({-2.25, 13.0});
  course.path = paced(corners);
  const auto steps = [](double length) { return static_cast<std::size_t>(std::floor(length / Course::kSpacing)); };
  course.first = steps((corners[1] - corners[0]).norm()) + 1;
  course.last = course.path.size() - 1 - steps((corners[corners.size() - 1] - corners[corners.size() - 2]).norm());
  return course;
}

}  // namespace hidwa_local_planner::test
