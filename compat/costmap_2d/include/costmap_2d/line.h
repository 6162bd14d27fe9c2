// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace costmap_2d {

/// Calls visit(index) for the cells on the straight line from (x0, y0) to (x1, y1), both ends included, in a
/// row-major grid `width` cells wide; the line ends early once it is `max_length` cells long. The whole line
/// lies in the grid.
template <typename Visit>
void visitLine(int x0, int y0, int x1, int y1, int width, double max_length, Visit visit) {
  const int dx = x1 - x0;
  const int dy = y1 - y0;
  const bool along_x = std::abs(dx) >= std::abs(dy);
  const int major = along_x ? std::abs(dx) : std::abs(dy);
  const int minor = along_x ? std::abs(dy) : std::abs(dx);
  const int step_x = dx < 0 ? -1 : 1;
  const int step_y = dy < 0 ? -width : width;
  const int major_step = along_x ? step_x : step_y;
  const int minor_step = along_x ? step_y : step_x;

  const double length = std::hypot(dx, dy);
  const int steps = length > max_length ? static_cast<int>(major * (max_length / length)) : major;
  int index = y0 * width + x0;
  int error = major / 2;
  visit(index);
  for (int i = 0; i < steps; ++i) {
    index += major_step;
    error += minor;
    if (error >= major) {
      error -= major;
      index += minor_step;
    }
    visit(index);
  }
}

}  // namespace costmap_2d
