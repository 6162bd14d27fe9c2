// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace costmap_2d {

/// -1 or 1; 0 counts as positive.
inline double sign(double x) { return x < 0.0 ? -1.0 : 1.0; }

/// -1, 0 or 1.
inline double sign0(double x) { return x < 0.0 ? -1.0 : (x > 0.0 ? 1.0 : 0.0); }

inline double distance(double x0, double y0, double x1, double y1) { return std::hypot(x1 - x0, y1 - y0); }

/// Distance from point p to the segment from (x0, y0) to (x1, y1).
double distanceToLine(double px, double py, double x0, double y0, double x1, double y1);

}  // namespace costmap_2d
