// SPDX-License-Identifier: BSD-3-Clause
// The same scene seen differently: turned by 90 degrees about the map frame's origin, mirrored, or moved by
// cells.
#pragma once

#include <cmath>
#include <functional>
#include <utility>

#include "support/scene.hpp"

namespace hidwa_local_planner::test {

inline void move_poses(Scene& scene, const std::function<Pose2(const Pose2&)>& moved) {
  scene.situation.pose = moved(scene.situation.pose);
  scene.situation.goal = moved(scene.situation.goal);
  for (Pose2& pose : scene.situation.plan) pose = moved(pose);
}

/// A quarter turn counter-clockwise: (x, y) becomes (-y, x).
inline Scene turned(const Scene& scene) {
  Scene out = scene;
  out.size_x = scene.size_y;
  out.size_y = scene.size_x;
  out.origin_x = -(scene.origin_y + scene.size_y * scene.resolution);
  out.origin_y = scene.origin_x;
  for (int j = 0; j < scene.size_y; ++j) {
    for (int i = 0; i < scene.size_x; ++i) {
      out.at({scene.size_y - 1 - j, i}) = scene.grid().at({i, j});
    }
  }
  move_poses(out, [](const Pose2& q) { return Pose2{-q.y, q.x, q.theta + M_PI / 2.0}; });
  return out;
}

/// Left and right exchanged: (x, y) becomes (x, -y).
inline Scene mirrored(const Scene& scene) {
  Scene out = scene;
  out.origin_y = -(scene.origin_y + scene.size_y * scene.resolution);
  for (int j = 0; j < scene.size_y; ++j) {
    for (int i = 0; i < scene.size_x; ++i) out.at({i, scene.size_y - 1 - j}) = scene.grid().at({i, j});
  }
  move_poses(out, [](const Pose2& q) { return Pose2{q.x, -q.y, -q.theta}; });
  for (Point& p : out.outline) p.y() = -p.y();
  for (Twist2* u : {&out.situation.velocity, &out.situation.last_command, &out.intent.u_h}) u->omega = -u->omega;
  return out;
}

/// Map, plan, goal and robot moved together by whole cells.
inline Scene translated(const Scene& scene, int cells_x, int cells_y) {
  Scene out = scene;
  const double dx = cells_x * scene.resolution, dy = cells_y * scene.resolution;
  out.origin_x += dx;
  out.origin_y += dy;
  move_poses(out, [&](const Pose2& q) { return Pose2{q.x + dx, q.y + dy, q.theta}; });
  return out;
}

}  // namespace hidwa_local_planner::test
