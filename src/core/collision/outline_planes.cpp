// SPDX-License-Identifier: BSD-3-Clause
#include "core/collision/outline_planes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hidwa_local_planner {
namespace {

// An outline's sides and its box's.
constexpr std::size_t kUsualPlanes = 64;

}  // namespace

void OutlinePlanes::reserve() {
  for (std::vector<double>* values : {&normal_x_, &normal_y_, &offset_}) values->reserve(kUsualPlanes);
}

void OutlinePlanes::turn(const Footprint& outline, const Pose2& pose, const Rotation& heading, double half) {
  double lo_x = std::numeric_limits<double>::infinity(), lo_y = lo_x, hi_x = -lo_x, hi_y = -lo_x;
  for (const Point& p : outline.outline()) {
    const Point at = heading.apply(p);
    lo_x = std::min(lo_x, at.x());
    hi_x = std::max(hi_x, at.x());
    lo_y = std::min(lo_y, at.y());
    hi_y = std::max(hi_y, at.y());
  }
  normal_x_.assign({1.0, -1.0, 0.0, 0.0});
  normal_y_.assign({0.0, 0.0, 1.0, -1.0});
  offset_.assign({pose.x + hi_x + half, half - lo_x - pose.x, pose.y + hi_y + half, half - lo_y - pose.y});
  for (const Footprint::Side& side : outline.sides()) {
    const Point normal = heading.apply(side.normal);
    const double x = normal.x(), y = normal.y();
    normal_x_.push_back(x);
    normal_y_.push_back(y);
    offset_.push_back(side.offset + half * (std::abs(x) + std::abs(y)) + x * pose.x + y * pose.y);
  }
}

}  // namespace hidwa_local_planner
