// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/util/outline.hpp"

namespace hidwa_local_planner {
namespace {

// Farther from the robot's centre no corner is believed [m].
constexpr double kFarthestCorner = 20.0;

bool is_finite_point(const Point& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); }

bool has_area(const Polygon& outline) { return std::abs(signed_area(outline)) > 1e-9; }

Point left_normal(const Point& from, const Point& to) {
  const Point d = (to - from).normalized();
  return {-d.y(), d.x()};
}

// Where two sides through `corner` meet, once each has moved by `padding` along its normal, of length 1.
Point meeting(const Point& corner, const Point& one, const Point& other, double padding) {
  return corner + padding * (one + other) / (1.0 + one.dot(other));
}

// The corner moved, of an outline that goes left around itself (around = 1) or right (-1). Where it is sharper than 60
// degrees its sides would meet more than twice the padding away: a third side across it, that far from it as the others
// from theirs, cuts the tip off.
void append_moved(const Point& before, const Point& here, const Point& after, double around, double padding,
                  Polygon& moved) {
  constexpr double kSharpest = -0.5;  // the normals' scalar product where the sides are 60 degrees apart
  const Point in = (here - before).normalized(), out = (after - here).normalized();
  const Point one = -around * Point(-in.y(), in.x()), other = -around * Point(-out.y(), out.x());
  const bool dent = around * cross(in, out) < -1e-12;
  if (dent || one.dot(other) >= kSharpest) {
    moved.push_back(meeting(here, one, other, padding));
    return;
  }
  const Point across = (in - out).normalized();
  moved.push_back(meeting(here, one, across, padding));
  moved.push_back(meeting(here, across, other, padding));
}

// Moves every side outwards by `padding`. False where one that lies in a dent has no length left.
bool move_sides(const Polygon& outline, double padding, Polygon& moved) {
  const std::size_t n = outline.size();
  const double around = signed_area(outline) > 0.0 ? 1.0 : -1.0;
  std::vector<std::size_t> first;  // in `moved`, of what each corner became
  for (std::size_t i = 0; i < n; ++i) {
    first.push_back(moved.size());
    append_moved(outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n], around, padding, moved);
  }
  first.push_back(moved.size());
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const Point side = moved[first[next]] - moved[first[i + 1] - 1];
    if (!(side.dot(outline[next] - outline[i]) > 0.0)) return false;
  }
  return true;
}

// Whether two segments share a point, unless they lie on one line.
bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return c_side * d_side <= 0.0 && a_side * b_side <= 0.0 && (c_side != 0.0 || d_side != 0.0);
}

bool crosses_itself(const Polygon& outline) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n - (i == 0 ? 1 : 0); ++j) {
      if (meet(outline[i], outline[i + 1], outline[j], outline[(j + 1) % n])) return true;
    }
  }
  return false;
}

Polygon square_around(const Point& p, double half) {
  return {p + Point(half, half), p + Point(-half, half), p + Point(-half, -half), p + Point(half, -half)};
}

// Empty where a corner bends the other way.
std::vector<Footprint::Side> convex_sides(const Polygon& outline) {
  std::vector<Footprint::Side> sides;
  const std::size_t n = outline.size();
  const double around = signed_area(outline) > 0.0 ? 1.0 : -1.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % n];
    const Point normal = -around * left_normal(a, b);
    const double offset = normal.dot(a);
    const auto beyond = [&](const Point& p) { return normal.dot(p) > offset + 1e-12; };
    if ((b - a).norm() <= 0.0 || std::any_of(outline.begin(), outline.end(), beyond)) return {};
    sides.push_back({normal, offset});
  }
  return sides;
}

}  // namespace

Footprint::Footprint(Polygon outline, double radius) : outline_(std::move(outline)), radius_(radius) {
  if (is_circle()) {
    inscribed_ = circumscribed_ = radius_;
    return;
  }
  inscribed_ = outline_.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    circumscribed_ = std::max(circumscribed_, outline_[i].norm());
    const double squared = squared_distance_to_segment(Point::Zero(), outline_[i], outline_[(i + 1) % outline_.size()]);
    inscribed_ = std::min(inscribed_, std::sqrt(squared));
    const Point way = outline_[(i + 1) % outline_.size()] - outline_[i];
    const double length2 = way.squaredNorm();
    edges_.push_back({way, length2 > 0.0 ? 1.0 / length2 : 0.0});
  }
  if (!contains(outline_, Point::Zero())) inscribed_ = 0.0;
  sides_ = convex_sides(outline_);
}

Footprint Footprint::from_outline(const Polygon& outline, double padding) {
  const Polygon corners = without_repeats(outline);
  if (!std::all_of(corners.begin(), corners.end(), is_finite_point)) return Footprint(corners);
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (const Point& corner : corners) {
    smallest = std::min(smallest, corner.norm());
    largest = std::max(largest, corner.norm());
  }
  // costmap_2d pads each coordinate by the same amount, so that a padded circle's corners lie up to
  // (sqrt(2) - 1) * padding apart: 5 mm at its default of 1 cm.
  constexpr double kRoundness = 0.006;  // [m]
  if (corners.size() >= 12 && largest - smallest <= kRoundness) return Footprint({}, largest + padding);
  return Footprint(corners).padded(padding);
}

// Many a cycle: without a division.
double Footprint::squared_distance_to_edge(std::size_t i, const Point& point) const {
  const Point a = outline_[i] - point;
  const double share = std::clamp(-a.dot(edges_[i].way) * edges_[i].per_squared_length, 0.0, 1.0);
  return (a + share * edges_[i].way).squaredNorm();
}

double Footprint::distance_to(const Point& point) const {
  if (is_circle()) return point.norm() - radius_;
  return sides_.empty() ? distance_to_any(point) : distance_to_convex(point);
}

// What is nearest to a point outside lies on a side that the point is in front of; what is inside is as deep as the
// nearest side.
double Footprint::distance_to_convex(const Point& point) const {
  double front = -std::numeric_limits<double>::infinity(), nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const double beyond = sides_[i].normal.dot(point) - sides_[i].offset;
    front = std::max(front, beyond);
    if (beyond > 0.0) nearest = std::min(nearest, squared_distance_to_edge(i, point));
  }
  return front > 0.0 ? std::sqrt(nearest) : front;
}

double Footprint::distance_to_any(const Point& point) const {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const Point a = outline_[i] - point, b = outline_[i + 1 < outline_.size() ? i + 1 : 0] - point;
    nearest = std::min(nearest, squared_distance_to_edge(i, point));
    inside = inside != crosses_positive_x(a, b);
  }
  return inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

Footprint Footprint::padded(double padding) const {
  if (padding == 0.0 || empty() || fault_of_corners() != nullptr) return *this;
  if (is_circle()) return Footprint({}, radius_ + padding);
  Polygon moved;
  if (has_area(outline_) && move_sides(outline_, padding, moved) && (!sides_.empty() || !crosses_itself(moved))) {
    return Footprint(std::move(moved));
  }
  moved.clear();
  const Polygon around = convex_hull(outline_);
  if (around.size() < 2) return Footprint(square_around(outline_.front(), padding));
  move_sides(around, padding, moved);
  return Footprint(std::move(moved));
}

const char* Footprint::fault_of_corners() const {
  if (!std::all_of(outline_.begin(), outline_.end(), is_finite_point))
    return "a corner of the footprint is not a number: correct the costmap's footprint";
  if (circumscribed_ > kFarthestCorner)
    return "the footprint reaches more than 20 m from the robot's centre: give it in metres";
  return nullptr;
}

const char* Footprint::fault() const {
  if (empty()) return "no footprint is set: give the costmap footprint or robot_radius";
  if (const char* fault = fault_of_corners()) return fault;
  if (!is_circle() && !has_area(outline_)) {
    return "the footprint is a line or a point: give corners that span an area, or set footprint_padding";
  }
  return nullptr;
}

}  // namespace hidwa_local_planner
