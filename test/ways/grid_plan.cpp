// SPDX-License-Identifier: BSD-3-Clause
#include "ways/grid_plan.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace hidwa_ways {
namespace {

// navfn's, for a cell: neutral, and so much a unit of cost.
constexpr double kNeutral = 50.0;
constexpr double kOfCost = 0.8;
constexpr std::uint8_t kBlocked = 253;
constexpr double kSpacing = 0.05;  // of the plan's points [m]
constexpr double kSmooth = 0.15;   // a running mean reaches so far to both sides [m]

// Points evenly spaced along a line of points.
std::vector<Spot> resampled(const std::vector<Spot>& line) {
  std::vector<Spot> points{line.front()};
  double left = kSpacing;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Spot a = line[k - 1], b = line[k];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    double at = 0.0;
    for (; length - at >= left; left = kSpacing) {
      at += left;
      points.push_back({a.x + (b.x - a.x) * at / length, a.y + (b.y - a.y) * at / length});
    }
    left -= length - at;
  }
  if (points.size() < 2 || left < 0.9 * kSpacing) points.push_back(line.back());
  return points;
}

// Both ends stay: towards them the mean is of fewer points.
std::vector<Spot> smoothed(const std::vector<Spot>& line) {
  std::vector<Spot> points;
  const std::size_t reach = static_cast<std::size_t>(std::lround(kSmooth / kSpacing));
  for (std::size_t k = 0; k < line.size(); ++k) {
    const std::size_t around = std::min({reach, k, line.size() - 1 - k});
    Spot sum;
    for (std::size_t n = k - around; n <= k + around; ++n) sum = {sum.x + line[n].x, sum.y + line[n].y};
    const auto count = static_cast<double>(2 * around + 1);
    points.push_back({sum.x / count, sum.y / count});
  }
  return points;
}

}  // namespace

GridPlan::GridPlan(const hidwa_local_planner::GridView& costs, const Spot& root)
    : columns_(costs.size_x),
      rows_(costs.size_y),
      resolution_(costs.resolution),
      origin_x_(costs.origin_x),
      origin_y_(costs.origin_y),
      cost_(costs.cell_count(), std::numeric_limits<float>::infinity()),
      length_(costs.cell_count(), 0.0F),
      next_(costs.cell_count(), -1) {
  const int at = index_of(root);
  if (at >= 0) flood({costs.costs, costs.costs + costs.cell_count()}, at);
}

void GridPlan::flood(const std::vector<std::uint8_t>& costs, int root) {
  static const Neighbour kAround[] = {
      {1, 0, 1.0},          {0, 1, 1.0},           {-1, 0, 1.0},          {0, -1, 1.0},
      {1, 1, M_SQRT2},      {-1, 1, M_SQRT2},      {1, -1, M_SQRT2},      {-1, -1, M_SQRT2},
      {2, 1, 2.2360679775}, {-2, 1, 2.2360679775}, {2, -1, 2.2360679775}, {-2, -1, 2.2360679775},
      {1, 2, 2.2360679775}, {-1, 2, 2.2360679775}, {1, -2, 2.2360679775}, {-1, -2, 2.2360679775}};
  using Entry = std::pair<float, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto cost_of = [&costs](int cell) { return costs[static_cast<std::size_t>(cell)]; };
  cost_[static_cast<std::size_t>(root)] = 0.0F;
  queue.push({0.0F, root});
  while (!queue.empty()) {
    const auto [cost, at] = queue.top();
    queue.pop();
    if (cost > cost_[static_cast<std::size_t>(at)]) continue;
    const int i = at % columns_, j = at / columns_;
    for (const Neighbour& n : kAround) {
      const int a = i + n.di, b = j + n.dj;
      if (a < 0 || b < 0 || a >= columns_ || b >= rows_) continue;
      const int cell = b * columns_ + a;
      if (cost_of(cell) >= kBlocked) continue;
      // A knight's move passes between two cells: both must be free.
      if (n.cells > 2.0 && (cost_of((j + n.dj / 2) * columns_ + i + n.di / 2) >= kBlocked ||
                            cost_of((b - n.dj / 2) * columns_ + a - n.di / 2) >= kBlocked))
        continue;
      const auto sum = static_cast<float>(cost + n.cells * (kNeutral + kOfCost * cost_of(cell)));
      if (sum >= cost_[static_cast<std::size_t>(cell)]) continue;
      cost_[static_cast<std::size_t>(cell)] = sum;
      length_[static_cast<std::size_t>(cell)] =
          length_[static_cast<std::size_t>(at)] + static_cast<float>(n.cells * resolution_);
      next_[static_cast<std::size_t>(cell)] = at;
      queue.push({sum, cell});
    }
  }
}

int GridPlan::index_of(const Spot& spot) const {
  const int i = static_cast<int>(std::floor((spot.x - origin_x_) / resolution_));
  const int j = static_cast<int>(std::floor((spot.y - origin_y_) / resolution_));
  return i < 0 || j < 0 || i >= columns_ || j >= rows_ ? -1 : j * columns_ + i;
}

bool GridPlan::reaches(const Spot& from) const {
  const int at = index_of(from);
  return at >= 0 && std::isfinite(cost_[static_cast<std::size_t>(at)]);
}

double GridPlan::length(const Spot& from) const {
  return static_cast<double>(length_[static_cast<std::size_t>(index_of(from))]);
}

std::vector<Spot> GridPlan::cells_from(const Spot& start) const {
  std::vector<Spot> line{start};
  for (int at = next_[static_cast<std::size_t>(index_of(start))]; at >= 0; at = next_[static_cast<std::size_t>(at)])
    line.push_back({origin_x_ + (at % columns_ + 0.5) * resolution_, origin_y_ + (at / columns_ + 0.5) * resolution_});
  return line;
}

std::vector<Pose2> GridPlan::from(const Spot& start) const {
  const std::vector<Spot> points = smoothed(resampled(cells_from(start)));
  std::vector<Pose2> plan;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Spot a = points[k == 0 ? 0 : k - 1], b = points[k == 0 ? std::min<std::size_t>(1, points.size() - 1) : k];
    plan.push_back({points[k].x, points[k].y, std::atan2(b.y - a.y, b.x - a.x)});
  }
  return plan;
}

}  // namespace hidwa_ways
