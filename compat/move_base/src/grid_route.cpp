// SPDX-License-Identifier: BSD-3-Clause
#include <costmap_2d/cost_values.h>
#include <move_base/grid_route.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace move_base {
namespace {

constexpr double kNeutralCost = 50.0;
constexpr double kCostFactor = 0.8;
constexpr std::uint8_t kHighestCost = 253;
// Less than kNeutralCost / sqrt(2), the least increment from a neighbour: a cell leaves its bucket final.
constexpr float kBucketWidth = 32.0f;

std::array<std::uint8_t, 256> travelCosts(bool allow_unknown) {
  std::array<std::uint8_t, 256> table{};
  for (int cost = 0; cost < costmap_2d::INSCRIBED_INFLATED_OBSTACLE; ++cost) {
    table[std::size_t(cost)] =
        static_cast<std::uint8_t>(std::min<double>(kHighestCost, kNeutralCost + kCostFactor * cost));
  }
  if (allow_unknown) table[costmap_2d::NO_INFORMATION] = kHighestCost;
  return table;
}

// T of a cell of cost `cost` whose least horizontal and vertical neighbours hold a and b: the root of
// (T - a)^2 + (T - b)^2 = cost^2, or one step from the lesser where the other is too far.
float upwind(float a, float b, float cost) {
  const float difference = std::abs(a - b);
  if (!(difference < cost)) return std::min(a, b) + cost;
  return 0.5f * (a + b + std::sqrt(2.0f * cost * cost - difference * difference));
}

std::size_t bucketOf(float cost) { return static_cast<std::size_t>(cost / kBucketWidth); }

int nearestCell(double coordinate) { return static_cast<int>(std::lround(coordinate)); }

}  // namespace

void GridRoute::setCosts(const unsigned char* costs, int width, int height, bool allow_unknown) {
  width_ = width;
  height_ = height;
  const auto table = travelCosts(allow_unknown);
  travel_.resize(std::size_t(width) * std::size_t(height));
  std::transform(costs, costs + travel_.size(), travel_.begin(), [&table](unsigned char cost) { return table[cost]; });
  // A closed border: no neighbour of an open cell lies outside.
  std::fill_n(travel_.begin(), width, std::uint8_t(0));
  std::fill_n(travel_.end() - width, width, std::uint8_t(0));
  for (int y = 0; y < height; ++y) travel_[cell(0, y)] = travel_[cell(width - 1, y)] = 0;
}

void GridRoute::open(int x, int y) {
  if (x > 0 && y > 0 && x < width_ - 1 && y < height_ - 1) {
    travel_[cell(x, y)] = static_cast<std::uint8_t>(kNeutralCost);
  }
}

void GridRoute::push(std::size_t index, float cost) {
  cost_to_[index] = cost;
  waiting_[index] = 1;
  buckets_[bucketOf(cost) % kBuckets].push_back(index);
}

void GridRoute::relax(std::size_t index) {
  const float cost = travel_[index];
  if (cost == 0.0f) return;
  const auto width = static_cast<std::size_t>(width_);
  const float across = std::min(cost_to_[index - 1], cost_to_[index + 1]);
  const float along = std::min(cost_to_[index - width], cost_to_[index + width]);
  const float candidate = upwind(across, along, cost);
  if (candidate < cost_to_[index]) push(index, candidate);
}

bool GridRoute::propagate(const GridPoint& start, const GridPoint& goal) {
  cost_to_.assign(travel_.size(), kUnreached);
  waiting_.assign(travel_.size(), 0);
  buckets_.resize(kBuckets);
  for (auto& bucket : buckets_) bucket.clear();
  start_ = start;
  const int start_x = nearestCell(start.x);
  const int start_y = nearestCell(start.y);
  if (!isOpen(start_x, start_y)) return false;
  push(cell(start_x, start_y), 0.0f);

  const bool has_goal = isOpen(nearestCell(goal.x), nearestCell(goal.y));
  const std::size_t goal_cell = has_goal ? cell(nearestCell(goal.x), nearestCell(goal.y)) : 0;
  const auto width = static_cast<std::size_t>(width_);
  std::size_t empty = 0;
  for (std::size_t current = 0; empty < kBuckets; ++current) {
    auto& bucket = buckets_[current % kBuckets];
    empty = bucket.empty() ? empty + 1 : 0;
    for (std::size_t i = 0; i < bucket.size(); ++i) {  // grows while it is worked off
      const std::size_t index = bucket[i];
      if (!waiting_[index]) continue;
      waiting_[index] = 0;
      const float here = cost_to_[index];
      for (const std::size_t next : {index - 1, index + 1, index - width, index + width}) {
        if (cost_to_[next] > here) relax(next);
      }
    }
    bucket.clear();
    // A goal in an earlier bucket is final, and so are the neighbours its gradient needs a few buckets later.
    constexpr std::size_t kMargin = 2 * kHighestCost / std::size_t(kBucketWidth);
    if (has_goal && cost_to_[goal_cell] < kUnreached && current > bucketOf(cost_to_[goal_cell]) + kMargin) break;
  }
  return has_goal && cost_to_[goal_cell] < kUnreached;
}

std::optional<GridPoint> GridRoute::nearestReached(const GridPoint& goal, double tolerance) const {
  std::optional<GridPoint> nearest;
  double least = tolerance;
  const int reach = static_cast<int>(std::ceil(tolerance)) + 1;
  for (int y = nearestCell(goal.y) - reach; y <= nearestCell(goal.y) + reach; ++y) {
    for (int x = nearestCell(goal.x) - reach; x <= nearestCell(goal.x) + reach; ++x) {
      const double distance = std::hypot(x - goal.x, y - goal.y);
      if (distance <= least && inside(x, y) && cost_to_[cell(x, y)] < kUnreached) {
        least = distance;
        nearest = GridPoint{double(x), double(y)};
      }
    }
  }
  return nearest;
}

float GridRoute::costTo(const GridPoint& point) const {
  const int x = nearestCell(point.x);
  const int y = nearestCell(point.y);
  return inside(x, y) ? cost_to_[cell(x, y)] : kUnreached;
}

}  // namespace move_base
