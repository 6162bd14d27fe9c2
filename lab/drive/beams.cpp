// SPDX-License-Identifier: BSD-3-Clause
#include "drive/beams.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace hidwa_local_planner {
namespace drive {
namespace {

// The greatest part in [0, 1] of the way from `from` to `to` that keeps within [least, greatest].
double part_within(double from, double to, double least, double greatest) {
  if (to > greatest) return (greatest - from) / (to - from);
  if (to < least) return (least - from) / (to - from);
  return 1.0;
}

// Calls visit(i, j) for the cells on the straight line between two cells, both included; the line ends early
// once it is `longest` cells long.
template <typename Visit>
void visit_line(Cell from, Cell to, double longest, Visit visit) {
  const int across = std::abs(to.i - from.i), up = std::abs(to.j - from.j);
  const int step_i = to.i < from.i ? -1 : 1, step_j = to.j < from.j ? -1 : 1;
  const bool along_i = across >= up;
  const int major = along_i ? across : up, minor = along_i ? up : across;
  int steps = major;
  // Squares save the root on lines that are short enough.
  const double squared = static_cast<double>(across * across + up * up);
  if (squared > longest * longest) steps = static_cast<int>(major * (longest / std::sqrt(squared)));
  int i = from.i, j = from.j;
  int error = major / 2;
  visit(i, j);
  for (int step = 0; step < steps; ++step) {
    error += minor;
    const bool beside = error >= major;
    if (beside) error -= major;
    i += along_i || beside ? step_i : 0;
    j += !along_i || beside ? step_j : 0;
    visit(i, j);
  }
}

}  // namespace

void project(const std::vector<float>& ranges, const sim::LaserSpec& laser, const sim::Pose& sensor, Beams& beams) {
  constexpr double kJustInside = 1e-4;  // [m]
  beams.origin = {sensor.x, sensor.y};
  beams.ends.clear();
  const double first = sensor.theta + laser.angle_min(), increment = laser.angle_increment();
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    double range = ranges[k];
    if (std::isinf(range) && range > 0.0) range = laser.range_max - kJustInside;
    if (!(range >= laser.range_min && range < laser.range_max)) continue;
    const double angle = first + static_cast<double>(k) * increment;
    beams.ends.emplace_back(sensor.x + range * std::cos(angle), sensor.y + range * std::sin(angle));
  }
}

void clear_along(const Beams& beams, double range, RollingGrid& grid) {
  const GridView view = grid.view();
  const Cell origin = view.cell_at(beams.origin.x(), beams.origin.y());
  if (!view.contains(origin)) return;
  // Just inside the far edges, so that a clipped beam ends in the last cell.
  const double side = (grid.cells() - 1e-3) * grid.resolution();
  const double least_x = grid.origin_x(), least_y = grid.origin_y();
  for (const Point& end : beams.ends) {
    const double part = std::min(part_within(beams.origin.x(), end.x(), least_x, least_x + side),
                                 part_within(beams.origin.y(), end.y(), least_y, least_y + side));
    const Point last = beams.origin + part * (end - beams.origin);
    const Cell cell = view.cell_at(last.x(), last.y());
    const Cell to{std::clamp(cell.i, 0, grid.cells() - 1), std::clamp(cell.j, 0, grid.cells() - 1)};
    visit_line(origin, to, range / grid.resolution(), [&grid](int i, int j) { grid.row(j)[i] = cost::kFree; });
  }
}

void mark_ends(const Beams& beams, double range, RollingGrid& grid) {
  const GridView view = grid.view();
  for (const Point& end : beams.ends) {
    if ((end - beams.origin).squaredNorm() >= range * range) continue;
    const Cell cell = view.cell_at(end.x(), end.y());
    if (view.contains(cell)) grid.row(cell.j)[cell.i] = cost::kLethal;
  }
}

void clear_polygon(const Polygon& polygon, RollingGrid& grid) {
  const GridView view = grid.view();
  int low = std::numeric_limits<int>::max(), high = -1;
  for (const Point& corner : polygon) {
    const Cell cell = view.cell_at(corner.x(), corner.y());
    if (!view.contains(cell)) return;
    low = std::min(low, cell.j);
    high = std::max(high, cell.j);
  }
  struct Span {
    int first = std::numeric_limits<int>::max();
    int last = -1;
  };
  std::vector<Span> spans(static_cast<std::size_t>(std::max(0, high - low + 1)));
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point& a = polygon[k];
    const Point& b = polygon[(k + 1) % polygon.size()];
    visit_line(view.cell_at(a.x(), a.y()), view.cell_at(b.x(), b.y()), std::numeric_limits<double>::infinity(),
               [&](int i, int j) {
                 Span& span = spans[static_cast<std::size_t>(j - low)];
                 span.first = std::min(span.first, i);
                 span.last = std::max(span.last, i);
               });
  }
  for (int j = low; j <= high; ++j) {
    const Span& span = spans[static_cast<std::size_t>(j - low)];
    for (int i = span.first; i <= span.last; ++i) grid.row(j)[i] = cost::kFree;
  }
}

}  // namespace drive
}  // namespace hidwa_local_planner
