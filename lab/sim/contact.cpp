// SPDX-License-Identifier: BSD-3-Clause
#include "sim/contact.hpp"

#include <algorithm>
#include <cstddef>

namespace hidwa_local_planner {
namespace sim {
namespace {

/// Narrows [t0, t1] to where low <= start + t * delta <= high; false where nothing remains.
bool clip(double start, double delta, double low, double high, double& t0, double& t1) {
  if (delta == 0.0) return start >= low && start <= high;
  const double a = (low - start) / delta;
  const double b = (high - start) / delta;
  t0 = std::max(t0, std::min(a, b));
  t1 = std::min(t1, std::max(a, b));
  return t0 <= t1;
}

bool segment_meets_cell(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double x, double y, double size) {
  double t0 = 0.0;
  double t1 = 1.0;
  return clip(a.x(), b.x() - a.x(), x, x + size, t0, t1) && clip(a.y(), b.y() - a.y(), y, y + size, t0, t1);
}

}  // namespace

bool overlaps_cell(const Polygon& polygon, double x, double y, double size) {
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    if (segment_meets_cell(polygon[j], polygon[i], x, y, size)) return true;
  }
  // No edge meets the cell: it lies wholly inside or wholly outside.
  return contains(polygon, {x + 0.5 * size, y + 0.5 * size});
}

bool overlaps_occupied(const OccupancyMap& map, const Polygon& polygon) {
  if (polygon.empty()) return false;
  const Box box = bounds(polygon);
  const int last_row = std::min(map.row(box.high.y()), map.height - 1);
  const int last_column = std::min(map.column(box.high.x()), map.width - 1);
  for (int row = std::max(map.row(box.low.y()), 0); row <= last_row; ++row) {
    for (int column = std::max(map.column(box.low.x()), 0); column <= last_column; ++column) {
      if (map.cells[map.index(column, row)] != Cell::kOccupied) continue;
      const double x = map.origin_x + column * map.resolution;
      const double y = map.origin_y + row * map.resolution;
      if (overlaps_cell(polygon, x, y, map.resolution)) return true;
    }
  }
  return false;
}

}  // namespace sim
}  // namespace hidwa_local_planner
