// SPDX-License-Identifier: BSD-3-Clause
// Scenes that an operator meets without a goal, drawn at random.
#pragma once

#include <string>

#include "goalless_world.hpp"
#include "support/round_outline.hpp"

namespace hidwa_local_planner::test {

/// A circle of 0.25 m, a rectangle of 0.6 x 0.45 m, and one of 0.9 x 0.5 m whose axle is near to its front.
inline Polygon goalless_outline(int kind) {
  if (kind == 1) return {{0.3, 0.225}, {-0.3, 0.225}, {-0.3, -0.225}, {0.3, -0.225}};
  if (kind == 2) return {{0.25, 0.25}, {-0.65, 0.25}, {-0.65, -0.25}, {0.25, -0.25}};
  return round_outline(0.25);
}

inline double half_width(int kind) { return kind == 0 ? 0.25 : kind == 1 ? 0.225 : 0.25; }  // [m]

inline GoallessScene make_scene(const std::string& kind, int outline, Random& random) {
  GoallessScene scene;
  scene.outline = goalless_outline(outline);
  scene.stick = {random.uniform(0.3, 0.8), 0.0};
  scene.noise = random.uniform(0.0, 0.02);
  scene.seed = random.bits();
  const double half = half_width(outline), side = random.chance(0.5) ? 1.0 : -1.0, far = random.uniform(2.0, 3.5);
  if (kind == "wall") {  // that crosses the way `far` ahead, and goes on for long
    const double angle = side * random.uniform(0.0, M_PI / 6.0);
    const Point along(std::cos(angle), std::sin(angle)), at(far, angle > 0.0 ? -0.0 : 0.0);
    scene.world.walls.push_back({at - 20.0 * along, at + 20.0 * along});
    // The robot begins on the side that it comes from: a wall met at a small angle is near to it at first.
    const double gap = far * std::abs(std::sin(angle));
    const Point away = Point(-std::sin(angle), std::cos(angle)) * side;  // from the wall to the robot
    const double more = std::max(0.0, half + 0.25 - gap);
    for (Wall& wall : scene.world.walls) wall = {wall.a - more * away, wall.b - more * away};
    scene.finish = 7.0;
  } else if (kind == "doorway") {  // met `far` ahead, missed by up to 0.15 m and 15 degrees
    const double angle = random.uniform(-M_PI / 12.0, M_PI / 12.0), miss = random.uniform(-0.15, 0.15);
    const double width = 2.0 * half + 0.3, thick = random.uniform(0.05, 0.25);
    const Point normal(std::cos(angle), std::sin(angle)), along(-normal.y(), normal.x());
    const Point centre = Point(far, 0.0) + miss * along;
    for (const double left : {1.0, -1.0}) {
      const Point front = centre + left * 0.5 * width * along, back = front + thick * normal;
      scene.world.walls.push_back({front, front + left * 6.0 * along});
      scene.world.walls.push_back({front, back});
      scene.world.walls.push_back({back, back + left * 6.0 * along});
    }
    scene.finish = far + 2.0;
  } else if (kind == "post") {  // clipped by up to half of the robot
    const double radius = random.uniform(0.03, 0.15);
    const double aside = side * (radius + random.uniform(0.0, half));
    scene.world.posts.push_back({Point(far, aside), radius});
    scene.finish = far + 2.0;
  } else {  // the corner of a block, likewise
    const double aside = side * random.uniform(0.0, half);
    scene.world.walls.push_back({Point(far, aside), Point(far, aside + side * 3.0)});
    scene.world.walls.push_back({Point(far, aside), Point(far + 3.0, aside)});
    scene.finish = far + 1.5;
  }
  return scene;
}

}  // namespace hidwa_local_planner::test
