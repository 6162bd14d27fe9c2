// SPDX-License-Identifier: BSD-3-Clause
#include "sim/disc_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double distance_to_border(const Eigen::Vector2d& p, const Polygon& polygon) {
  double least = kInfinity;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    least = std::min(least, distance_to_segment(p, polygon[j], polygon[i]));
  }
  return least;
}

}  // namespace

DiscField::DiscField(std::vector<Eigen::Vector2d> centres, double radius)
    : centres_(std::move(centres)), radius_(radius) {
  if (!(radius_ > 0.0) || !std::isfinite(radius_)) {
    throw std::invalid_argument("the radius of the discs must be positive");
  }
  for (const Eigen::Vector2d& centre : centres_) {
    if (!centre.allFinite()) throw std::invalid_argument("the centre of a disc is not a number");
  }
}

double DiscField::gap(const Polygon& polygon, double at_most) const {
  if (polygon.empty()) return at_most;
  const Box box = bounds(polygon);
  const double reach = at_most + radius_;
  double least = at_most;
  for (const Eigen::Vector2d& centre : centres_) {
    const bool far = ((box.low - centre).array() > reach).any() || ((centre - box.high).array() > reach).any();
    if (far) continue;
    if (contains(polygon, centre)) return 0.0;
    least = std::min(least, distance_to_border(centre, polygon) - radius_);
  }
  return std::max(0.0, least);
}

double DiscField::distance(const Eigen::Vector2d& point, double at_most) const {
  double least = at_most;
  for (const Eigen::Vector2d& centre : centres_) least = std::min(least, (centre - point).norm() - radius_);
  return least;
}

double DiscField::range(double x, double y, double angle, double range_max) const {
  const Eigen::Vector2d from(x, y);
  const double c = std::cos(angle), s = std::sin(angle);
  double nearest = kInfinity;
  for (const Eigen::Vector2d& centre : centres_) {
    nearest = std::min(nearest, ray_to_disc(centre - from, c, s, radius_));
  }
  return nearest <= range_max ? nearest : kInfinity;
}

}  // namespace sim
}  // namespace hidwa_local_planner
