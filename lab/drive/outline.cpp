// SPDX-License-Identifier: BSD-3-Clause
#include "drive/outline.hpp"

#include <cmath>
#include <utility>

namespace hidwa_local_planner {
namespace drive {
namespace {

double away_from_zero(double value, double by) {
  if (value == 0.0) return 0.0;
  return value + std::copysign(by, value);
}

}  // namespace

sim::Polygon telepresence_footprint() {
  return {{0.277, 0.115},   {0.115, 0.277},   {-0.115, 0.277}, {-0.277, 0.115},
          {-0.277, -0.115}, {-0.115, -0.277}, {0.115, -0.277}, {0.277, -0.115}};
}

Polygon circle_outline(double robot_radius, double padding) {
  constexpr int kCorners = 16;
  Polygon outline;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * M_PI * i / kCorners;
    outline.emplace_back(robot_radius * std::cos(angle), robot_radius * std::sin(angle));
  }
  return padded_outline(std::move(outline), padding);
}

Polygon padded_outline(Polygon outline, double padding) {
  for (Point& corner : outline) {
    corner = {away_from_zero(corner.x(), padding), away_from_zero(corner.y(), padding)};
  }
  return outline;
}

}  // namespace drive
}  // namespace hidwa_local_planner
