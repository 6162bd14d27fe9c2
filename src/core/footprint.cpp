// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/core/footprint.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace hidwa_local_planner {
namespace {

double distance_to_segment(const Point& a, const Point& b) {
  const Point d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp(-a.dot(d) / length2, 0.0, 1.0) : 0.0;
  return (a + t * d).norm();
}

double signed_area(const Polygon& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

bool contains_origin(const Polygon& outline) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& a = outline[i];
    const Point& b = outline[(i + 1) % outline.size()];
    if ((a.y() > 0.0) != (b.y() > 0.0)) {
      if (0.0 < a.x() + (b.x() - a.x()) * (-a.y()) / (b.y() - a.y())) inside = !inside;
    }
  }
  return inside;
}

Point left_normal(const Point& from, const Point& to) {
  const Point d = (to - from).normalized();
  return {-d.y(), d.x()};
}

// Moves every side outwards; a corner goes where its two moved sides meet, at most twice the padding away.
Polygon offset(const Polygon& outline, double padding) {
  const std::size_t n = outline.size();
  const double outward = signed_area(outline) > 0.0 ? -padding : padding;  // the left of a side is inside or outside
  Polygon moved(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point& here = outline[i];
    const Point before = left_normal(outline[(i + n - 1) % n], here);
    const Point after = left_normal(here, outline[(i + 1) % n]);
    const double denominator = std::max(0.25, 1.0 + before.dot(after));
    moved[i] = here + outward * (before + after) / denominator;
  }
  return moved;
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

Polygon without_repeats(const Polygon& outline) {
  Polygon kept;
  for (const Point& p : outline) {
    if (kept.empty() || (p - kept.back()).norm() > 1e-9) kept.push_back(p);
  }
  while (kept.size() > 1 && (kept.front() - kept.back()).norm() <= 1e-9) kept.pop_back();
  return kept;
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
    inscribed_ = std::min(inscribed_, distance_to_segment(outline_[i], outline_[(i + 1) % outline_.size()]));
  }
  if (!contains_origin(outline_)) inscribed_ = 0.0;
  sides_ = convex_sides(outline_);
}

Footprint Footprint::from_outline(const Polygon& outline, double padding) {
  const Polygon corners = without_repeats(outline);
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

Footprint Footprint::padded(double padding) const {
  if (padding == 0.0 || empty()) return *this;
  if (is_circle()) return Footprint({}, radius_ + padding);
  return Footprint(offset(outline_, padding));
}

}  // namespace hidwa_local_planner
