// SPDX-License-Identifier: BSD-3-Clause
#include "shape.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_attack {
namespace {

Spot unit_normal(const Spot& a, const Spot& b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  return {(b.y - a.y) / length, (a.x - b.x) / length};
}

double along(const Spot& n, const Spot& p) { return n.x * p.x + n.y * p.y; }

Shape rectangle(double rear, double front, double right, double left) {
  return {{{rear, right}, {front, right}, {front, left}, {rear, left}}, 0.0};
}

Shape regular(int corners, double radius) {
  Shape shape;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * M_PI * (k + 0.5) / corners;
    shape.corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return shape;
}

// Where n1 . p = d1 and n2 . p = d2.
Spot meeting(const Spot& n1, double d1, const Spot& n2, double d2) {
  const double area = n1.x * n2.y - n1.y * n2.x;
  return {(d1 * n2.y - d2 * n1.y) / area, (n1.x * d2 - n2.x * d1) / area};
}

double distance_to_side(const Spot& a, const Spot& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double t = std::clamp(-(a.x * dx + a.y * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(a.x + t * dx, a.y + t * dy);
}

}  // namespace

const char* name_of(Outline outline) {
  switch (outline) {
    case Outline::octagon:
      return "octagon";
    case Outline::long_rectangle:
      return "long_rectangle";
    case Outline::off_centre:
      return "off_centre";
    case Outline::circle:
      return "circle";
  }
  return "";
}

Shape shape_of(Outline outline) {
  switch (outline) {
    case Outline::octagon:
      return regular(8, 0.30);
    case Outline::long_rectangle:
      return rectangle(-0.45, 0.45, -0.20, 0.20);
    case Outline::off_centre:
      return rectangle(-0.10, 0.55, -0.22, 0.18);
    case Outline::circle:
      return {{}, 0.25};
  }
  return {};
}

Shape padded(const Shape& shape, double by) {
  if (shape.radius > 0.0) return {{}, shape.radius + by};
  Shape grown;
  const std::size_t n = shape.corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Spot& here = shape.corners[k];
    const Spot before = unit_normal(shape.corners[(k + n - 1) % n], here);
    const Spot after = unit_normal(here, shape.corners[(k + 1) % n]);
    grown.corners.push_back(meeting(before, along(before, here) + by, after, along(after, here) + by));
  }
  return grown;
}

double outermost(const Shape& shape) {
  double most = shape.radius;
  for (const Spot& corner : shape.corners) most = std::max(most, std::hypot(corner.x, corner.y));
  return most;
}

double innermost(const Shape& shape) {
  if (shape.radius > 0.0) return shape.radius;
  double least = outermost(shape);
  const std::size_t n = shape.corners.size();
  for (std::size_t k = 0; k < n; ++k)
    least = std::min(least, distance_to_side(shape.corners[k], shape.corners[(k + 1) % n]));
  return least;
}

std::vector<Spot> told_corners(const Shape& shape) {
  return shape.radius > 0.0 ? regular(16, shape.radius).corners : shape.corners;
}

Placed::Placed(const Shape& shape, const Pose2& pose) : radius_(shape.radius), centre_{pose.x, pose.y} {
  if (radius_ > 0.0) {
    low_ = {pose.x - radius_, pose.y - radius_};
    high_ = {pose.x + radius_, pose.y + radius_};
    return;
  }
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  std::vector<Spot> corners;
  for (const Spot& p : shape.corners) corners.push_back({pose.x + c * p.x - s * p.y, pose.y + s * p.x + c * p.y});
  low_ = high_ = corners.front();
  for (const Spot& p : corners) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    Side side;
    side.normal = unit_normal(corners[k], corners[(k + 1) % corners.size()]);
    side.least = side.most = along(side.normal, corners[k]);
    for (const Spot& p : corners) {
      side.least = std::min(side.least, along(side.normal, p));
      side.most = std::max(side.most, along(side.normal, p));
    }
    sides_.push_back(side);
  }
}

double Placed::depth_in(double x, double y, double side) const {
  return radius_ > 0.0 ? circle_depth(x, y, side) : polygon_depth(x, y, side);
}

// Separating axes: two convex shapes part along a normal of one of them, and the shortest way is one of those.
double Placed::polygon_depth(double x, double y, double side) const {
  double depth = std::min({high_.x - x, x + side - low_.x, high_.y - y, y + side - low_.y});
  for (const Side& s : sides_) {
    const double middle = s.normal.x * (x + 0.5 * side) + s.normal.y * (y + 0.5 * side);
    const double half = 0.5 * side * (std::abs(s.normal.x) + std::abs(s.normal.y));
    depth = std::min({depth, s.most - (middle - half), middle + half - s.least});
  }
  return depth;
}

double Placed::circle_depth(double x, double y, double side) const {
  const double dx = std::max({x - centre_.x, centre_.x - x - side, 0.0});
  const double dy = std::max({y - centre_.y, centre_.y - y - side, 0.0});
  if (dx > 0.0 || dy > 0.0) return radius_ - std::hypot(dx, dy);
  const double inside = std::min({centre_.x - x, x + side - centre_.x, centre_.y - y, y + side - centre_.y});
  return radius_ + inside;
}

}  // namespace hidwa_attack
