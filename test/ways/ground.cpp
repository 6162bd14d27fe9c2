// SPDX-License-Identifier: BSD-3-Clause
#include "ways/ground.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_ways {

Turned::Turned(const Shape& shape, double heading)
    : radius_(shape.radius), core_(hidwa_attack::innermost(shape) * std::sqrt(0.5)) {
  x_ = y_ = {-radius_, radius_};
  const double c = std::cos(heading), s = std::sin(heading);
  std::vector<Spot> corners;
  for (const Spot& p : shape.corners) corners.push_back({c * p.x - s * p.y, s * p.x + c * p.y});
  for (std::size_t k = 0; k < corners.size(); ++k) {
    Spot a = corners[k], b = corners[(k + 1) % corners.size()];
    if (a.y > b.y) std::swap(a, b);
    edges_.push_back({a, b, b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0.0});
    x_ = {std::min(x_.low, a.x), std::max(x_.high, a.x)};
    x_ = {std::min(x_.low, b.x), std::max(x_.high, b.x)};
    y_ = {std::min(y_.low, a.y), std::max(y_.high, b.y)};
  }
}

Turned::Interval Turned::across(double bottom, double top) const {
  if (radius_ > 0.0) {
    const double off = std::max({bottom, -top, 0.0});
    if (off > radius_) return {1.0, -1.0};
    const double half = std::sqrt(radius_ * radius_ - off * off);
    return {-half, half};
  }
  Interval extent{1e9, -1e9};
  for (const Edge& edge : edges_) {
    if (edge.b.y < bottom || edge.a.y > top) continue;
    const double from = bottom > edge.a.y ? edge.a.x + (bottom - edge.a.y) * edge.slope : edge.a.x;
    const double to = top < edge.b.y ? edge.a.x + (top - edge.a.y) * edge.slope : edge.b.x;
    extent.low = std::min({extent.low, from, to});
    extent.high = std::max({extent.high, from, to});
  }
  return extent;
}

Ground::Ground(const World& world)
    : resolution_(world.resolution()),
      per_metre_(1.0 / world.resolution()),
      columns_(world.columns()),
      rows_(world.rows()),
      sums_(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1), 0) {
  for (int j = 0; j < rows_; ++j) {
    int row = 0;
    for (int i = 0; i < columns_; ++i) {
      row += world.lethal(i, j) ? 1 : 0;
      sums_[static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(columns_ + 1) +
            static_cast<std::size_t>(i + 1)] = sum(i + 1, j) + row;
    }
  }
}

bool Ground::any(int first_i, int first_j, int last_i, int last_j) const {
  if (first_i < 0 || first_j < 0 || last_i >= columns_ || last_j >= rows_) return true;
  return sum(last_i + 1, last_j + 1) - sum(first_i, last_j + 1) - sum(last_i + 1, first_j) + sum(first_i, first_j) > 0;
}

bool Ground::overlaps(const Turned& outline, double x, double y) const {
  const int first = cell(y + outline.y().low), last = cell(y + outline.y().high);
  if (!any(cell(x + outline.x().low), first, cell(x + outline.x().high), last)) return false;
  const double core = outline.core();
  if (any(cell(x - core), cell(y - core), cell(x + core), cell(y + core))) return true;
  for (int j = first; j <= last; ++j) {
    const Turned::Interval extent = outline.across(j * resolution_ - y, (j + 1) * resolution_ - y);
    if (extent.low <= extent.high && any(cell(x + extent.low), j, cell(x + extent.high), j)) return true;
  }
  return false;
}

}  // namespace hidwa_ways
