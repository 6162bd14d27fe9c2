// SPDX-License-Identifier: BSD-3-Clause
// Worlds for the tracker: an office with a corridor, doors, desks, columns and chairs, and a hall with nothing in it.
#pragma once

#include "support/scan_world.hpp"

namespace hidwa_local_planner::test {

/// 16 x 12 m: two rooms and a hall along a corridor of 2.4 m.
inline ScanWorld office() {
  ScanWorld world;
  world.add_box(0.0, 0.0, 16.0, 12.0);
  const double corridor[2] = {4.8, 7.2};
  for (double y : corridor) {  // doors of 1 m at x = 3 and x = 11
    world.walls.push_back({{0.0, y}, {3.0, y}});
    world.walls.push_back({{4.0, y}, {11.0, y}});
    world.walls.push_back({{12.0, y}, {16.0, y}});
  }
  world.walls.push_back({{8.0, 0.0}, {8.0, 4.8}});
  world.walls.push_back({{7.0, 7.2}, {7.0, 12.0}});
  world.add_box(1.0, 0.6, 2.6, 1.4);  // desks
  world.add_box(5.2, 2.6, 6.8, 3.4);
  world.add_box(13.6, 9.0, 15.2, 9.8);
  world.add_box(9.4, 10.4, 11.0, 11.2);
  for (double x : {9.5, 13.0}) world.posts.push_back({{x, 2.4}, 0.2});  // columns
  for (double x : {1.3, 1.7}) {                                         // the legs of chairs and a table
    for (double y : {1.8, 2.2}) world.posts.push_back({{x, y}, 0.015});
  }
  for (double x : {3.2, 4.6}) {
    for (double y : {9.2, 10.4}) world.posts.push_back({{x, y}, 0.025});
  }
  return world;
}

/// Through the corridor and into every room, and back.
inline std::vector<Point> office_round() {
  return {{1.5, 6.0},  {3.5, 6.0},  {3.5, 3.0},  {4.6, 1.2},  {3.5, 3.0},  {3.5, 6.0},  {11.5, 6.0}, {11.5, 3.5},
          {14.5, 3.5}, {14.5, 1.0}, {11.2, 1.2}, {11.5, 3.5}, {11.5, 6.0}, {11.5, 8.4}, {12.6, 8.4}, {11.5, 8.4},
          {11.5, 6.0}, {3.5, 6.0},  {3.5, 8.3},  {5.6, 9.8},  {3.5, 8.3},  {3.5, 6.0}};
}

/// 14 x 14 m with walls all around.
inline ScanWorld hall() {
  ScanWorld world;
  world.add_box(0.0, 0.0, 14.0, 14.0);
  return world;
}

}  // namespace hidwa_local_planner::test
