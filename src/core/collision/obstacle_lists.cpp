// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/obstacle_lists.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/collision/rounding.hpp"
#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

// Lists are padded to whole registers by repeating their last cell.
constexpr std::size_t kPad = 4;

// Cells in all lists of a usual cycle: room that is taken once.
constexpr std::size_t kUsualCells = 16384;

// The smallest over all points of how far it lies beyond the plane that it lies farthest beyond.
HIDWA_VECTOR_CLONES
double least_beyond(const OutlinePlanes& planes, const double* x, const double* y, std::size_t count, double enough) {
  const double *normal_x = planes.normal_x(), *normal_y = planes.normal_y(), *offset = planes.offset();
  const std::size_t sides = planes.count();
  Four least = Four{} + enough;
  for (std::size_t first = 0; first < count; first += kPad) {
    Four px, py;
    std::memcpy(&px, x + first, sizeof(px));
    std::memcpy(&py, y + first, sizeof(py));
    Four most = Four{} - std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < sides; ++m) {
      const Four beyond = px * normal_x[m] + py * normal_y[m] - offset[m];
      most = most < beyond ? beyond : most;
    }
    least = most < least ? most : least;
  }
  return std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
}

}  // namespace

void disc_reach(double radius, double resolution, int slack, std::vector<int>& reach) {
  reach.clear();
  for (int dy = 0;; ++dy) {
    const double rows = std::max(0, dy - slack) * resolution;
    if (rows >= radius) break;
    const double columns = std::sqrt(radius * radius - rows * rows) / resolution;
    const int reached = static_cast<int>(std::ceil(columns - kRounding)) - 1 + slack;
    if (reached < 0) break;
    reach.push_back(reached);
  }
}

void ObstacleLists::prepare(const Window& window) {
  window_ = window;
  disc_reach(window.solid_reach, window.resolution, 1, solid_reach_);
  disc_reach(window.core_reach, window.resolution, 1, core_reach_);
  spans_.assign(static_cast<std::size_t>(window.cells->width()) * static_cast<std::size_t>(window.cells->height()),
                Span{});
  x_.clear();
  y_.clear();
  x_.reserve(kUsualCells);
  y_.reserve(kUsualCells);
  planes_.reserve();
}

void ObstacleLists::move_to(const Point& corner) {
  window_.corner = corner;
  // Lists pile up for as long as nothing changes: anew before they need more room than a usual cycle's.
  if (x_.size() > kUsualCells / 2) prepare(Window(window_));
}

const ObstacleLists::Span& ObstacleLists::span_of(Cell cell) {
  Span& span = spans_[static_cast<std::size_t>(cell.j) * static_cast<std::size_t>(window_.cells->width()) +
                      static_cast<std::size_t>(cell.i)];
  if (span.known) return span;
  span.known = true;
  span.first = static_cast<std::uint32_t>(x_.size());
  collect(window_.solid, cell, solid_reach_);
  span.solid = static_cast<std::uint32_t>(x_.size()) - span.first;
  if (window_.core != 0) collect(window_.core, cell, core_reach_);
  span.core = static_cast<std::uint32_t>(x_.size()) - span.first - span.solid;
  return span;
}

void ObstacleLists::collect(std::uint8_t flag, Cell around, const std::vector<int>& reach) {
  const CellFlags& cells = *window_.cells;
  const int rows = static_cast<int>(reach.size()) - 1;
  const std::size_t before = x_.size();
  for (int row = std::max(0, around.j - rows); row <= std::min(cells.height() - 1, around.j + rows); ++row) {
    const int columns = reach[static_cast<std::size_t>(std::abs(row - around.j))];
    const int last = std::min(cells.width() - 1, around.i + columns);
    int i = cells.find(flag, row, std::max(0, around.i - columns), last);
    for (; i <= last; i = cells.find(flag, row, i + 1, last)) {
      x_.push_back((i + 0.5) * window_.resolution);
      y_.push_back((row + 0.5) * window_.resolution);
    }
  }
  if (x_.size() == before) return;
  while ((x_.size() - before) % kPad != 0) {
    x_.push_back(x_.back());
    y_.push_back(y_.back());
  }
}

double ObstacleLists::smallest_gap(Cell cell, const Pose2& pose, const Rotation& heading, const Footprint& outline,
                                   double cap) {
  const Span span = span_of(cell);
  if (outline.is_circle()) return gap_of_circle(span, pose, outline.radius() - kRounding, cap);
  return gap_of_polygon(span, pose, heading, outline, cap);
}

double ObstacleLists::gap_of_polygon(const Span& span, const Pose2& pose, const Rotation& heading,
                                     const Footprint& outline, double cap) {
  if (span.solid == 0) return cap;
  // Lists count from the window's corner: small numbers, little rounding.
  planes_.turn(outline, {pose.x - window_.corner.x(), pose.y - window_.corner.y(), pose.theta}, heading,
               0.5 * window_.resolution);
  return least_beyond(planes_, x_.data() + span.first, y_.data() + span.first, span.solid, cap);
}

double ObstacleLists::gap_of_circle(const Span& span, const Pose2& pose, double radius, double cap) const {
  const double half = 0.5 * window_.resolution;
  const double from_x = pose.x - window_.corner.x(), from_y = pose.y - window_.corner.y();
  const auto nearest2 = [&](std::size_t first, std::size_t count) {
    double least2 = std::numeric_limits<double>::infinity();
    for (std::size_t k = first; k < first + count; ++k) {
      const double dx = beyond(x_[k] - from_x, half), dy = beyond(y_[k] - from_y, half);
      least2 = std::min(least2, dx * dx + dy * dy);
    }
    return least2;
  };
  const double solid = std::sqrt(nearest2(span.first, span.solid)) - radius;
  if (solid <= 0.0) return solid;
  const double core = std::sqrt(nearest2(span.first + span.solid, span.core));
  return std::min({solid, std::max(core, kRounding), cap});
}

}  // namespace hidwa_local_planner
