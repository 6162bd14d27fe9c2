// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/outline_depth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/collision/collision.hpp"
#include "core/util/outline.hpp"
#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

// Of each point: how far it lies inside the plane that it lies least inside.
HIDWA_VECTOR_CLONES
void least_inside(const OutlinePlanes& planes, const double* __restrict x, const double* __restrict y,
                  std::size_t count, double* __restrict inside) {
  std::fill_n(inside, count, std::numeric_limits<double>::infinity());
  for (std::size_t m = 0; m < planes.count(); ++m) {
    const double normal_x = planes.normal_x()[m], normal_y = planes.normal_y()[m], offset = planes.offset()[m];
    for (std::size_t k = 0; k < count; ++k) {
      const double in = offset - x[k] * normal_x - y[k] * normal_y;
      inside[k] = in < inside[k] ? in : inside[k];
    }
  }
}

}  // namespace

void OutlineDepth::prepare(const Footprint& footprint, double resolution) {
  footprint_ = convex_ = &footprint;
  half_ = 0.5 * resolution;
  planes_.reserve();
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
  planes_.turn(*convex_, pose, heading, half_);  // a cell overlaps a side by as much as its centre lies inside
  least_inside(planes_, x, y, count, depth);
  if (convex_ != footprint_) drop_untouched(pose, heading, x, y, count, depth);
}

double OutlineDepth::in_circle(double dx, double dy) const {
  const double beside = std::abs(dx) - half_, above = std::abs(dy) - half_;
  if (beside <= 0.0 && above <= 0.0) return footprint_->radius() - std::max(beside, above);
  const double out_x = std::max(beside, 0.0), out_y = std::max(above, 0.0);
  return footprint_->radius() - std::sqrt(out_x * out_x + out_y * out_y);
}

// What only the hull overlaps is not touched: who knows how far away it is.
void OutlineDepth::drop_untouched(const Pose2& pose, const Rotation& heading, const double* x, const double* y,
                                  std::size_t count, double* depth) {
  corners_.resize(footprint_->outline().size());
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const Point& p = footprint_->outline()[k];
    corners_[k] = heading.placed(pose.x, pose.y, p.x(), p.y());
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (depth[k] > 0.0 && !overlaps_square(corners_, x[k] - half_, y[k] - half_, 2.0 * half_)) depth[k] = -half_;
  }
}

}  // namespace hidwa_local_planner
