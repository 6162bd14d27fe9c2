// SPDX-License-Identifier: BSD-3-Clause
#include "benchmark/naive_footprint.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner::test {
namespace {

// Beyond what is asked for [m].
constexpr double kMore = 1e-3;

double gap(double value, double lo, double hi) { return std::max({lo - value, value - hi, 0.0}); }

// The part [enter, leave] of a line a + t d that lies between lo and hi; empty where enter >= leave.
void narrow(double a, double d, double lo, double hi, double& enter, double& leave) {
  if (d == 0.0) {
    if (a <= lo || a >= hi) leave = enter;
    return;
  }
  const double one = (lo - a) / d, two = (hi - a) / d;
  enter = std::max(enter, std::min(one, two));
  leave = std::min(leave, std::max(one, two));
}

// A side of the outline runs through the square, or the square lies inside the outline.
bool meets_square(const Polygon& outline, double x, double y, double side) {
  const double middle_x = x + side / 2, middle_y = y + side / 2;
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    double enter = 0.0, leave = 1.0;
    narrow(a.x(), b.x() - a.x(), x, x + side, enter, leave);
    narrow(a.y(), b.y() - a.y(), y, y + side, enter, leave);
    if (enter < leave) return true;
    if ((a.y() > middle_y) == (b.y() > middle_y)) continue;
    if (middle_x < a.x() + (b.x() - a.x()) * (middle_y - a.y()) / (b.y() - a.y())) inside = !inside;
  }
  return inside;
}

}  // namespace

NaiveFootprint::NaiveFootprint(const GridView& grid, const NaiveBody& body, bool unknown_is_obstacle)
    : grid_(grid),
      body_(body),
      unknown_is_obstacle_(unknown_is_obstacle),
      outer_radius_(naive_outer_radius(body)),
      placed_(body.corners.size()) {}

bool NaiveFootprint::obstacle(Cell cell) const {
  return !grid_.contains(cell) || naive_is_obstacle(grid_.at(cell), unknown_is_obstacle_);
}

bool NaiveFootprint::collides(const Pose2& pose) const {
  const Cell cell = grid_.cell_at(pose.x, pose.y);
  if (obstacle(cell)) return true;
  if (body_.radius > 0.0) return grid_.at(cell) == cost::kInscribed || disc_collides(pose);
  return polygon_collides(pose);
}

bool NaiveFootprint::disc_collides(const Pose2& pose) const {
  const Cell lo = grid_.cell_at(pose.x - body_.radius, pose.y - body_.radius);
  const Cell hi = grid_.cell_at(pose.x + body_.radius, pose.y + body_.radius);
  for (int j = lo.j; j <= hi.j; ++j) {
    for (int i = lo.i; i <= hi.i; ++i) {
      if (!obstacle({i, j})) continue;
      const double x = grid_.origin_x + i * grid_.resolution, y = grid_.origin_y + j * grid_.resolution;
      const double dx = gap(pose.x, x, x + grid_.resolution), dy = gap(pose.y, y, y + grid_.resolution);
      if (dx * dx + dy * dy < body_.radius * body_.radius) return true;
    }
  }
  return false;
}

void NaiveFootprint::place(const Pose2& pose) const {
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  for (std::size_t k = 0; k < placed_.size(); ++k) {
    const Point& p = body_.corners[k];
    placed_[k] = {pose.x + c * p.x() - s * p.y(), pose.y + s * p.x() + c * p.y()};
  }
}

bool NaiveFootprint::keeps(const Pose2& pose, double needed) const {
  if (collides(pose)) return false;
  return needed <= 0.0 || room(pose, needed + kMore) > needed;
}

// Cells whose square is farther from the centre cannot be nearer: of two corners the gap is up to sqrt(2) less.
double NaiveFootprint::room(const Pose2& pose, double most) const {
  place(pose);
  axes_.assign({{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}});
  for (const Point& normal : naive_normals(placed_)) axes_.push_back(normal);
  const double around = outer_radius_ + 1.5 * most, side = grid_.resolution;
  const Cell lo = grid_.cell_at(pose.x - around, pose.y - around);
  const Cell hi = grid_.cell_at(pose.x + around, pose.y + around);
  double least = most;
  for (int j = lo.j; j <= hi.j; ++j) {
    for (int i = lo.i; i <= hi.i; ++i) {
      const bool inscribed = body_.radius > 0.0 && grid_.contains({i, j}) && grid_.at({i, j}) == cost::kInscribed;
      if (!inscribed && !obstacle({i, j})) continue;
      const double x = grid_.origin_x + i * side, y = grid_.origin_y + j * side;
      const double from_centre = naive_to_square(pose, x, y, side);
      if (from_centre >= around) continue;
      if (body_.radius > 0.0) {
        least = std::min(least, inscribed ? from_centre : from_centre - body_.radius);
      } else {
        least = std::min(least, naive_separating_gap(axes_, placed_, naive_square(x, y, side)));
      }
    }
  }
  return least;
}

bool NaiveFootprint::polygon_collides(const Pose2& pose) const {
  place(pose);
  Point least(INFINITY, INFINITY), most(-INFINITY, -INFINITY);
  for (std::size_t k = 0; k < placed_.size(); ++k) {
    least = least.cwiseMin(placed_[k]);
    most = most.cwiseMax(placed_[k]);
  }
  const Cell lo = grid_.cell_at(least.x(), least.y());
  const Cell hi = grid_.cell_at(most.x(), most.y());
  for (int j = lo.j; j <= hi.j; ++j) {
    for (int i = lo.i; i <= hi.i; ++i) {
      if (!obstacle({i, j})) continue;
      const double x = grid_.origin_x + i * grid_.resolution, y = grid_.origin_y + j * grid_.resolution;
      if (meets_square(placed_, x, y, grid_.resolution)) return true;
    }
  }
  return false;
}

}  // namespace hidwa_local_planner::test
