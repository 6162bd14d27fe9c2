// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/costmap_math.h>

#include <algorithm>

namespace costmap_2d {

double distanceToLine(double px, double py, double x0, double y0, double x1, double y1) {
  const double dx = x1 - x0;
  const double dy = y1 - y0;
  const double length_squared = dx * dx + dy * dy;
  const double along =
      length_squared > 0.0 ? std::clamp(((px - x0) * dx + (py - y0) * dy) / length_squared, 0.0, 1.0) : 0.0;
  return distance(px, py, x0 + along * dx, y0 + along * dy);
}

}  // namespace costmap_2d
