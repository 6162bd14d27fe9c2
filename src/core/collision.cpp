// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/collision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hidwa_local_planner {
namespace {

// Lengths of this order are rounding [m].
constexpr double kRounding = 1e-9;

// Clips the parameter range [t0, t1] of the segment a + t d to the open slab (lo, hi).
bool clip(double a, double d, double lo, double hi, double& t0, double& t1) {
  if (d == 0.0) return a > lo && a < hi;
  double enter = (lo - a) / d;
  double leave = (hi - a) / d;
  if (enter > leave) std::swap(enter, leave);
  t0 = std::max(t0, enter);
  t1 = std::min(t1, leave);
  return t0 < t1;
}

bool segment_enters(const Point& a, const Point& b, double x, double y, double side) {
  double t0 = 0.0, t1 = 1.0;
  return clip(a.x(), b.x() - a.x(), x, x + side, t0, t1) && clip(a.y(), b.y() - a.y(), y, y + side, t0, t1);
}

bool contains(const Polygon& polygon, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point& a = polygon[i];
    const Point& b = polygon[j];
    if ((a.y() > y) != (b.y() > y) && x < a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y())) inside = !inside;
  }
  return inside;
}

double gap(double value, double lo, double hi) { return std::max({lo - value, value - hi, 0.0}); }

bool disc_overlaps(double x, double y, double radius, double cell_x, double cell_y, double side) {
  const double dx = gap(x, cell_x, cell_x + side);
  const double dy = gap(y, cell_y, cell_y + side);
  return dx * dx + dy * dy < (radius - kRounding) * (radius - kRounding);
}

// How many columns away an obstacle in a row `dy` rows away can be and still be nearer than `radius`, when each of the
// two cells is nearer by `slack` cells an axis than its index says. Negative: none.
int columns_within(int dy, double radius, double resolution, int slack) {
  const double rows = std::max(0, dy - slack) * resolution;
  if (rows >= radius) return -1;
  const double columns = std::sqrt(radius * radius - rows * rows) / resolution;
  return static_cast<int>(std::ceil(columns - kRounding)) - 1 + slack;
}

void disc_reach(double radius, double resolution, int slack, std::vector<int>& reach) {
  reach.clear();
  for (int dy = 0;; ++dy) {
    const int columns = columns_within(dy, radius, resolution, slack);
    if (columns < 0) break;
    reach.push_back(columns);
  }
}

}  // namespace

bool overlaps_square(const Polygon& polygon, double x, double y, double side) {
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    if (segment_enters(polygon[j], polygon[i], x, y, side)) return true;
  }
  return contains(polygon, x + 0.5 * side, y + 0.5 * side);
}

void CollisionChecker::prepare(const GridView& grid, const Footprint& footprint, bool unknown_is_obstacle,
                               const Pose2& centre, double reach) {
  grid_ = grid;
  footprint_ = &footprint;
  unknown_is_obstacle_ = unknown_is_obstacle;
  const double resolution = grid.resolution;
  // One cell more than the outline reaches, for clear(), and the obstacles that this may touch.
  const double outer = footprint.circumscribed_radius() + resolution;
  const int radius = static_cast<int>(std::ceil((reach + outer) / resolution)) + 2;
  const Cell middle = grid.cell_at(centre.x, centre.y);
  first_ = {middle.i - radius, middle.j - radius};
  obstacles_.reset(2 * radius + 1, 2 * radius + 1);
  for (int j = 0; j < obstacles_.height(); ++j) {
    for (int i = 0; i < obstacles_.width(); ++i) {
      if (obstacle({first_.i + i, first_.j + j})) obstacles_.set(i, j);
    }
  }
  disc_reach(outer, resolution, 1, reach_);
  margin_ = static_cast<int>(reach_.size());
  obstacles_.dilate(reach_, near_);
  disc_reach(footprint.inscribed_radius() - kRounding, resolution, 0, reach_);
  obstacles_.dilate(reach_, hit_);
}

bool CollisionChecker::clear(double x, double y) const {
  const Cell cell = grid_.cell_at(x, y);
  if (!in_reach(cell) || near_.test(cell.i - first_.i, cell.j - first_.j)) return false;
  // Inscribed cells, which only a circle minds, lie where costs rise.
  return !footprint_->is_circle() || grid_.at(cell) == cost::kFree;
}

// An outline need not contain the robot's centre: only where it does, the centre's cell alone can decide.
bool CollisionChecker::centre_collides(Cell cell, const Footprint& outline) const {
  if (outline.inscribed_radius() <= 0.0) return false;
  if (obstacle(cell)) return true;
  return outline.is_circle() && grid_.at(cell) == cost::kInscribed;
}

bool CollisionChecker::collides(const Pose2& pose) const {
  const Cell cell = grid_.cell_at(pose.x, pose.y);
  if (centre_collides(cell, *footprint_)) return true;
  if (in_reach(cell)) {
    const int i = cell.i - first_.i, j = cell.j - first_.j;
    if (!near_.test(i, j)) return false;
    if (hit_.test(i, j)) return true;
  }
  return overlaps_any(pose, *footprint_);
}

bool CollisionChecker::collides(const Pose2& pose, const Footprint& outline) const {
  const Cell cell = grid_.cell_at(pose.x, pose.y);
  if (centre_collides(cell, outline)) return true;
  if (in_reach(cell) && !near_.test(cell.i - first_.i, cell.j - first_.j)) return false;
  return overlaps_any(pose, outline);
}

// Calls visit(cell) for obstacle cells that the outline overlaps until it returns false.
template <typename Visit>
void CollisionChecker::visit_overlapped(const Pose2& pose, const Footprint& outline, Visit&& visit) const {
  double lo_x = pose.x - outline.radius(), hi_x = pose.x + outline.radius();
  double lo_y = pose.y - outline.radius(), hi_y = pose.y + outline.radius();
  if (!outline.is_circle()) {
    const double c = std::cos(pose.theta), s = std::sin(pose.theta);
    corners_.resize(outline.outline().size());
    lo_x = lo_y = std::numeric_limits<double>::infinity();
    hi_x = hi_y = -lo_x;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const Point& p = outline.outline()[k];
      corners_[k] = {pose.x + c * p.x() - s * p.y(), pose.y + s * p.x() + c * p.y()};
      lo_x = std::min(lo_x, corners_[k].x());
      hi_x = std::max(hi_x, corners_[k].x());
      lo_y = std::min(lo_y, corners_[k].y());
      hi_y = std::max(hi_y, corners_[k].y());
    }
  }
  const Cell lo = grid_.cell_at(lo_x, lo_y);
  const Cell hi = grid_.cell_at(hi_x, hi_y);
  const bool inside = in_window(lo) && in_window(hi);
  for (int j = lo.j; j <= hi.j; ++j) {
    if (inside && !obstacles_.any(j - first_.j, lo.i - first_.i, hi.i - first_.i)) continue;
    for (int i = lo.i; i <= hi.i; ++i) {
      if (inside ? !obstacles_.test(i - first_.i, j - first_.j) : !obstacle({i, j})) continue;
      const double x = grid_.origin_x + i * grid_.resolution;
      const double y = grid_.origin_y + j * grid_.resolution;
      const bool overlaps = outline.is_circle()
                                ? disc_overlaps(pose.x, pose.y, outline.radius(), x, y, grid_.resolution)
                                : overlaps_square(corners_, x, y, grid_.resolution);
      if (overlaps && !visit(Cell{i, j})) return;
    }
  }
}

bool CollisionChecker::overlaps_any(const Pose2& pose, const Footprint& outline) const {
  bool found = false;
  visit_overlapped(pose, outline, [&found](Cell) {
    found = true;
    return false;
  });
  return found;
}

int CollisionChecker::penetration(const Pose2& pose) const {
  int cells = 0;
  visit_overlapped(pose, *footprint_, [&cells](Cell) {
    ++cells;
    return true;
  });
  return cells;
}

double CollisionChecker::clearance(const Pose2& pose) const {
  double nearest2 = std::numeric_limits<double>::infinity();
  for (int j = 0; j < obstacles_.height(); ++j) {
    if (!obstacles_.any(j, 0, obstacles_.width() - 1)) continue;
    for (int i = 0; i < obstacles_.width(); ++i) {
      if (!obstacles_.test(i, j)) continue;
      const double x = grid_.origin_x + (first_.i + i) * grid_.resolution;
      const double y = grid_.origin_y + (first_.j + j) * grid_.resolution;
      const double dx = gap(pose.x, x, x + grid_.resolution), dy = gap(pose.y, y, y + grid_.resolution);
      nearest2 = std::min(nearest2, dx * dx + dy * dy);
    }
  }
  return std::sqrt(nearest2);
}

}  // namespace hidwa_local_planner
