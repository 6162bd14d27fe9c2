// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/obstacle_lists.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "hidwa_local_planner/core/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

// Lengths of this order are rounding [m].
constexpr double kRounding = 1e-9;

// Lists are padded to whole registers by repeating their last cell.
constexpr std::size_t kPad = 4;

// Cells in all lists of a usual cycle: room that is taken once.
constexpr std::size_t kUsualCells = 16384;

// An outline's sides and its box's.
constexpr std::size_t kUsualPlanes = 64;

struct Planes {
  const double* normal_x;
  const double* normal_y;
  const double* offset;
  std::size_t count;
};

// The smallest over all points of how far it lies beyond the plane that it lies farthest beyond. Two convex shapes share
// area unless a side of one of them has the other beyond it.
HIDWA_VECTOR_CLONES
double least_beyond(const Planes& planes, const double* x, const double* y, std::size_t count, double enough) {
  Four least = Four{} + enough;
  for (std::size_t first = 0; first < count; first += kPad) {
    Four px, py;
    std::memcpy(&px, x + first, sizeof(px));
    std::memcpy(&py, y + first, sizeof(py));
    Four most = Four{} - std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < planes.count; ++m) {
      const Four beyond = px * planes.normal_x[m] + py * planes.normal_y[m] - planes.offset[m];
      most = most < beyond ? beyond : most;
    }
    least = most < least ? most : least;
  }
  return std::min(std::min(least[0], least[1]), std::min(least[2], least[3]));
}

double beyond(double value, double half) { return std::max(std::abs(value) - half, 0.0); }

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
  spans_.assign(static_cast<std::size_t>(window.solid->width()) * static_cast<std::size_t>(window.solid->height()), Span{});
  x_.clear();
  y_.clear();
  x_.reserve(kUsualCells);
  y_.reserve(kUsualCells);
  for (std::vector<double>* values : {&normal_x_, &normal_y_, &offset_}) values->reserve(kUsualPlanes);
}

void ObstacleLists::move_to(double corner_x, double corner_y) {
  window_.corner_x = corner_x;
  window_.corner_y = corner_y;
  // Lists pile up for as long as nothing changes: anew before they need more room than a usual cycle's.
  if (x_.size() > kUsualCells / 2) prepare(Window(window_));
}

const ObstacleLists::Span& ObstacleLists::span_of(int i, int j) {
  Span& span = spans_[static_cast<std::size_t>(j) * static_cast<std::size_t>(window_.solid->width()) +
                      static_cast<std::size_t>(i)];
  if (span.known) return span;
  span.known = true;
  span.first = static_cast<std::uint32_t>(x_.size());
  collect(*window_.solid, i, j, solid_reach_);
  span.solid = static_cast<std::uint32_t>(x_.size()) - span.first;
  if (window_.core != nullptr) collect(*window_.core, i, j, core_reach_);
  span.core = static_cast<std::uint32_t>(x_.size()) - span.first - span.solid;
  return span;
}

void ObstacleLists::collect(const BitGrid& marks, int i, int j, const std::vector<int>& reach) {
  const int rows = static_cast<int>(reach.size()) - 1;
  const std::size_t before = x_.size();
  for (int row = std::max(0, j - rows); row <= std::min(marks.height() - 1, j + rows); ++row) {
    const int columns = reach[static_cast<std::size_t>(std::abs(row - j))];
    const int last = std::min(marks.width() - 1, i + columns);
    for (int from = std::max(0, i - columns); from <= last; from += 64) {
      std::uint64_t bits = marks.bits(row, from);
      if (last - from < 63) bits &= ~std::uint64_t{0} >> (63 - (last - from));
      for (; bits != 0; bits &= bits - 1) {
        x_.push_back((from + __builtin_ctzll(bits) + 0.5) * window_.resolution);
        y_.push_back((row + 0.5) * window_.resolution);
      }
    }
  }
  if (x_.size() == before) return;
  while ((x_.size() - before) % kPad != 0) {
    x_.push_back(x_.back());
    y_.push_back(y_.back());
  }
}

double ObstacleLists::smallest_gap(int i, int j, const Pose2& pose, const Rotation& heading, const Footprint& outline,
                                   double cap) {
  const Span span = span_of(i, j);
  if (outline.is_circle()) return gap_of_circle(span, pose, outline.radius() - kRounding, cap);
  return gap_of_polygon(span, pose, heading, outline, cap);
}

double ObstacleLists::gap_of_polygon(const Span& span, const Pose2& pose, const Rotation& heading,
                                     const Footprint& outline, double cap) {
  if (span.solid == 0) return cap;
  double lo_x = std::numeric_limits<double>::infinity(), lo_y = lo_x, hi_x = -lo_x, hi_y = -lo_x;
  for (const Point& p : outline.outline()) {
    const double x = heading.c * p.x() - heading.s * p.y(), y = heading.s * p.x() + heading.c * p.y();
    lo_x = std::min(lo_x, x);
    hi_x = std::max(hi_x, x);
    lo_y = std::min(lo_y, y);
    hi_y = std::max(hi_y, y);
  }
  const double half = 0.5 * window_.resolution;
  // Lists count from the window's corner: small numbers, little rounding.
  const double from_x = pose.x - window_.corner_x, from_y = pose.y - window_.corner_y;
  normal_x_.assign({1.0, -1.0, 0.0, 0.0});
  normal_y_.assign({0.0, 0.0, 1.0, -1.0});
  offset_.assign({from_x + hi_x + half, half - lo_x - from_x, from_y + hi_y + half, half - lo_y - from_y});
  for (const Footprint::Side& side : outline.sides()) {
    const double x = heading.c * side.normal.x() - heading.s * side.normal.y();
    const double y = heading.s * side.normal.x() + heading.c * side.normal.y();
    normal_x_.push_back(x);
    normal_y_.push_back(y);
    offset_.push_back(side.offset + half * (std::abs(x) + std::abs(y)) + x * from_x + y * from_y);
  }
  const Planes planes{normal_x_.data(), normal_y_.data(), offset_.data(), offset_.size()};
  return least_beyond(planes, x_.data() + span.first, y_.data() + span.first, span.solid, cap);
}

double ObstacleLists::gap_of_circle(const Span& span, const Pose2& pose, double radius, double cap) const {
  const double half = 0.5 * window_.resolution;
  const double from_x = pose.x - window_.corner_x, from_y = pose.y - window_.corner_y;
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
