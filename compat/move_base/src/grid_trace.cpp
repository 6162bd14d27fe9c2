// SPDX-License-Identifier: BSD-3-Clause
// Following travel costs downhill.
#include <move_base/grid_route.h>

#include <algorithm>
#include <cmath>

namespace move_base {
namespace {

constexpr double kStep = 0.5;  // [cells]

// The slope between two neighbours of a cell, from what of the three was reached.
double slope(float before, float here, float after) {
  if (before < kUnreached && after < kUnreached) return 0.5 * (double(after) - double(before));
  if (before < kUnreached) return double(here) - double(before);
  if (after < kUnreached) return double(after) - double(here);
  return 0.0;
}

}  // namespace

GridPoint GridRoute::gradient(int x, int y) const {
  if (x < 1 || y < 1 || x >= width_ - 1 || y >= height_ - 1) return {};
  const float here = cost_to_[cell(x, y)];
  if (!(here < kUnreached)) return {};
  const GridPoint uphill{slope(cost_to_[cell(x - 1, y)], here, cost_to_[cell(x + 1, y)]),
                         slope(cost_to_[cell(x, y - 1)], here, cost_to_[cell(x, y + 1)])};
  const double length = std::hypot(uphill.x, uphill.y);
  return length > 0.0 ? GridPoint{uphill.x / length, uphill.y / length} : GridPoint{};
}

GridPoint GridRoute::gradientAt(const GridPoint& point) const {
  const int x = static_cast<int>(std::floor(point.x));
  const int y = static_cast<int>(std::floor(point.y));
  const double right = point.x - x;
  const double up = point.y - y;
  GridPoint sum;
  const auto add = [&](int cx, int cy, double weight) {
    const GridPoint part = gradient(cx, cy);
    sum.x += weight * part.x;
    sum.y += weight * part.y;
  };
  add(x, y, (1.0 - right) * (1.0 - up));
  add(x + 1, y, right * (1.0 - up));
  add(x, y + 1, (1.0 - right) * up);
  add(x + 1, y + 1, right * up);
  return sum;
}

GridPoint GridRoute::lowestNeighbour(const GridPoint& point) const {
  const int x = static_cast<int>(std::lround(point.x));
  const int y = static_cast<int>(std::lround(point.y));
  GridPoint lowest{double(x), double(y)};
  float least = cost_to_[cell(x, y)];
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const bool cuts_corner = dx != 0 && dy != 0 && !(isOpen(x + dx, y) && isOpen(x, y + dy));
      if (cuts_corner || !inside(x + dx, y + dy) || !(cost_to_[cell(x + dx, y + dy)] < least)) continue;
      least = cost_to_[cell(x + dx, y + dy)];
      lowest = {double(x + dx), double(y + dy)};
    }
  }
  return lowest;
}

std::vector<GridPoint> GridRoute::trace(const GridPoint& goal) const {
  std::vector<GridPoint> route{goal};
  GridPoint here = goal;
  // The gradient leads downhill but for rounding next to closed cells. Whenever a few steps bring no new
  // least cost, the way goes on from cell centre to lowest neighbour, which always does.
  constexpr int kPatience = 6;
  float least = costTo(goal);
  int since_least = 0;
  while (std::hypot(here.x - start_.x, here.y - start_.y) > 1.0 && costTo(here) > 0.0f) {
    const GridPoint uphill = gradientAt(here);
    const double length = std::hypot(uphill.x, uphill.y);
    GridPoint next{here.x - kStep * uphill.x / length, here.y - kStep * uphill.y / length};
    if (!(length > 1e-6) || since_least > kPatience || !(costTo(next) < kUnreached)) next = lowestNeighbour(here);
    here = next;
    route.push_back(here);
    const float cost = costTo(here);
    since_least = cost < least ? 0 : since_least + 1;
    least = std::min(least, cost);
  }
  route.push_back(start_);
  std::reverse(route.begin(), route.end());
  return route;
}

}  // namespace move_base
