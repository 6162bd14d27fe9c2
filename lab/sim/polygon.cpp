// SPDX-License-Identifier: BSD-3-Clause
#include "sim/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hidwa_local_planner {
namespace sim {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Whether p, known to lie on the line through a and b, lies between them.
bool between(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  return p.x() >= std::min(a.x(), b.x()) && p.x() <= std::max(a.x(), b.x()) && p.y() >= std::min(a.y(), b.y()) &&
         p.y() <= std::max(a.y(), b.y());
}

}  // namespace

Polygon transformed(const Polygon& polygon, const Pose& pose) {
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  Polygon result;
  result.reserve(polygon.size());
  for (const Eigen::Vector2d& p : polygon) {
    result.emplace_back(pose.x + c * p.x() - s * p.y(), pose.y + s * p.x() + c * p.y());
  }
  return result;
}

Polygon circle_polygon(double radius, int corners) {
  Polygon result;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * M_PI * i / corners;
    result.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return result;
}

double circumscribed_radius(const Polygon& polygon) {
  double radius = 0.0;
  for (const Eigen::Vector2d& p : polygon) radius = std::max(radius, p.norm());
  return radius;
}

Box bounds(const Polygon& polygon) {
  Box box{polygon.front(), polygon.front()};
  for (const Eigen::Vector2d& p : polygon) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

bool contains(const Polygon& polygon, const Eigen::Vector2d& point) {
  // Even-odd rule: how often a ray to the right crosses the border.
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[j];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (point.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y());
    if (point.x() < x) inside = !inside;
  }
  return inside;
}

bool segments_touch(const Eigen::Vector2d& a0, const Eigen::Vector2d& a1, const Eigen::Vector2d& b0,
                    const Eigen::Vector2d& b1) {
  const double s0 = cross(a1 - a0, b0 - a0);
  const double s1 = cross(a1 - a0, b1 - a0);
  const double t0 = cross(b1 - b0, a0 - b0);
  const double t1 = cross(b1 - b0, a1 - b0);
  if (((s0 > 0.0 && s1 < 0.0) || (s0 < 0.0 && s1 > 0.0)) && ((t0 > 0.0 && t1 < 0.0) || (t0 < 0.0 && t1 > 0.0))) {
    return true;
  }
  return (s0 == 0.0 && between(a0, a1, b0)) || (s1 == 0.0 && between(a0, a1, b1)) ||
         (t0 == 0.0 && between(b0, b1, a0)) || (t1 == 0.0 && between(b0, b1, a1));
}

bool touch(const Polygon& a, const Polygon& b) {
  if (a.empty() || b.empty()) return false;
  const Box box_a = bounds(a);
  const Box box_b = bounds(b);
  if ((box_a.low.array() > box_b.high.array()).any() || (box_b.low.array() > box_a.high.array()).any()) return false;
  for (std::size_t i = 0, j = a.size() - 1; i < a.size(); j = i++) {
    for (std::size_t k = 0, l = b.size() - 1; k < b.size(); l = k++) {
      if (segments_touch(a[j], a[i], b[l], b[k])) return true;
    }
  }
  return contains(a, b.front()) || contains(b, a.front());
}

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

Pose compose(const Pose& a, const Pose& b) {
  const double c = std::cos(a.theta);
  const double s = std::sin(a.theta);
  return {a.x + c * b.x - s * b.y, a.y + s * b.x + c * b.y, normalized(a.theta + b.theta)};
}

Pose inverse(const Pose& a) {
  const double c = std::cos(a.theta);
  const double s = std::sin(a.theta);
  return {-c * a.x - s * a.y, s * a.x - c * a.y, normalized(-a.theta)};
}

double normalized(double angle) {
  const double reduced = std::remainder(angle, 2.0 * M_PI);
  return reduced <= -M_PI ? M_PI : reduced;
}

}  // namespace sim
}  // namespace hidwa_local_planner
