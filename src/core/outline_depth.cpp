// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/outline_depth.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "hidwa_local_planner/core/collision.hpp"
#include "hidwa_local_planner/core/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

// An outline's sides and a cell's.
constexpr std::size_t kUsualPlanes = 64;

// A corner this little off the line of its neighbours is none [m^2].
constexpr double kStraight = 1e-12;

struct Planes {
  const double* normal_x;
  const double* normal_y;
  const double* offset;
  std::size_t count;
};

// Of each point: how far it lies inside the plane that it lies least inside.
HIDWA_VECTOR_CLONES
void least_inside(const Planes& planes, const double* x, const double* y, std::size_t count, double* inside) {
  for (std::size_t first = 0; first < count; first += 4) {
    Four px, py;
    std::memcpy(&px, x + first, sizeof(px));
    std::memcpy(&py, y + first, sizeof(py));
    Four least = Four{} + std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < planes.count; ++m) {
      const Four in = planes.offset[m] - px * planes.normal_x[m] - py * planes.normal_y[m];
      least = in < least ? in : least;
    }
    std::memcpy(inside + first, &least, sizeof(least));
  }
}

bool turns_left(const Point& a, const Point& b, const Point& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) > kStraight;
}

// One half of the hull, of points in order (Andrew 1979).
template <typename Iterator>
void add_half(Iterator begin, Iterator end, Polygon& hull) {
  const std::size_t kept = hull.size();
  for (Iterator p = begin; p != end; ++p) {
    while (hull.size() >= kept + 2 && !turns_left(hull[hull.size() - 2], hull.back(), *p)) hull.pop_back();
    hull.push_back(*p);
  }
  hull.pop_back();  // the other half begins with it
}

Polygon convex_hull(Polygon points) {
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  Polygon hull;
  add_half(points.begin(), points.end(), hull);
  add_half(points.rbegin(), points.rend(), hull);
  return hull;
}

}  // namespace

void OutlineDepth::prepare(const Footprint& footprint, double resolution) {
  footprint_ = convex_ = &footprint;
  half_ = 0.5 * resolution;
  for (std::vector<double>* values : {&normal_x_, &normal_y_, &offset_}) values->reserve(kUsualPlanes);
  if (footprint.is_circle() || !footprint.sides().empty()) return;
  make_hull();
  convex_ = &hull_;
}

// Made anew only when the outline changes.
void OutlineDepth::make_hull() {
  if (hull_from_ == footprint_->outline()) return;
  hull_from_ = footprint_->outline();
  hull_ = Footprint(convex_hull(hull_from_));
}

void OutlineDepth::of(const Pose2& pose, const Rotation& heading, const double* x, const double* y, std::size_t count,
                      double* depth) {
  if (footprint_->is_circle()) {
    for (std::size_t k = 0; k < count; ++k) depth[k] = in_circle(x[k] - pose.x, y[k] - pose.y);
    return;
  }
  turn_planes(pose, heading);
  least_inside({normal_x_.data(), normal_y_.data(), offset_.data(), offset_.size()}, x, y, count, depth);
  if (convex_ != footprint_) drop_untouched(pose, heading, x, y, count, depth);
}

double OutlineDepth::in_circle(double dx, double dy) const {
  const double beside = std::abs(dx) - half_, above = std::abs(dy) - half_;
  if (beside <= 0.0 && above <= 0.0) return footprint_->radius() - std::max(beside, above);
  const double out_x = std::max(beside, 0.0), out_y = std::max(above, 0.0);
  return footprint_->radius() - std::sqrt(out_x * out_x + out_y * out_y);
}

// All sides moved outwards by a cell's reach: a cell overlaps one by as much as its centre lies inside.
void OutlineDepth::turn_planes(const Pose2& pose, const Rotation& heading) {
  double lo_x = std::numeric_limits<double>::infinity(), lo_y = lo_x, hi_x = -lo_x, hi_y = -lo_x;
  for (const Point& p : convex_->outline()) {
    const double x = heading.c * p.x() - heading.s * p.y(), y = heading.s * p.x() + heading.c * p.y();
    lo_x = std::min(lo_x, x);
    hi_x = std::max(hi_x, x);
    lo_y = std::min(lo_y, y);
    hi_y = std::max(hi_y, y);
  }
  normal_x_.assign({1.0, -1.0, 0.0, 0.0});
  normal_y_.assign({0.0, 0.0, 1.0, -1.0});
  offset_.assign({pose.x + hi_x + half_, half_ - lo_x - pose.x, pose.y + hi_y + half_, half_ - lo_y - pose.y});
  for (const Footprint::Side& side : convex_->sides()) {
    const double x = heading.c * side.normal.x() - heading.s * side.normal.y();
    const double y = heading.s * side.normal.x() + heading.c * side.normal.y();
    normal_x_.push_back(x);
    normal_y_.push_back(y);
    offset_.push_back(side.offset + half_ * (std::abs(x) + std::abs(y)) + x * pose.x + y * pose.y);
  }
}

// What only the hull overlaps is not touched: who knows how far away it is.
void OutlineDepth::drop_untouched(const Pose2& pose, const Rotation& heading, const double* x, const double* y,
                                  std::size_t count, double* depth) {
  corners_.resize(footprint_->outline().size());
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const Point& p = footprint_->outline()[k];
    corners_[k] = {pose.x + heading.c * p.x() - heading.s * p.y(), pose.y + heading.s * p.x() + heading.c * p.y()};
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (depth[k] > 0.0 && !overlaps_square(corners_, x[k] - half_, y[k] - half_, 2.0 * half_)) depth[k] = -half_;
  }
}

}  // namespace hidwa_local_planner
