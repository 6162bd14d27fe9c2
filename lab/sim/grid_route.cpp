// SPDX-License-Identifier: BSD-3-Clause
#include "sim/grid_route.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr std::array<int, 8> kColumnStep{1, 1, 0, -1, -1, -1, 0, 1};
constexpr std::array<int, 8> kRowStep{0, 1, 1, 1, 0, -1, -1, -1};
constexpr std::uint8_t kGoal = 8;
constexpr std::uint8_t kNone = 9;
constexpr std::size_t kNoCell = std::numeric_limits<std::size_t>::max();
constexpr double kStartTolerance = 0.5;  // [m]

std::uint8_t opposite(std::size_t direction) { return static_cast<std::uint8_t>((direction + 4) % 8); }

}  // namespace

double inflation_cost(double distance, const RouteClearance& clearance) {
  return distance <= clearance.robot_radius
             ? 1.0
             : std::exp(-clearance.cost_scaling_factor * (distance - clearance.robot_radius));
}

GridRoute::GridRoute(const OccupancyMap& map, const RouteClearance& clearance, const Eigen::Vector2d& goal,
                     const std::optional<Eigen::Vector2d>& start)
    : map_(map), toward_goal_(map.cells.size(), kNone) {
  std::size_t last = kNoCell;
  if (start && map.inside(map.column(start->x()), map.row(start->y()))) {
    last = map.index(map.column(start->x()), map.row(start->y()));
  }
  const int column = map.column(goal.x()), row = map.row(goal.y());
  if (map.inside(column, row)) search(DistanceField::to_obstacles(map), clearance, column, row, last);
}

void GridRoute::search(const DistanceField& field, const RouteClearance& clearance, int goal_column, int goal_row,
                       std::size_t last) {
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
  std::vector<float> cost(toward_goal_.size(), std::numeric_limits<float>::max());
  const std::size_t goal = map_.index(goal_column, goal_row);
  cost[goal] = 0.0F;
  toward_goal_[goal] = kGoal;
  open.emplace(0.0F, static_cast<std::uint32_t>(goal));
  const auto width = static_cast<std::uint32_t>(map_.width);
  while (!open.empty()) {
    const Entry top = open.top();
    open.pop();
    if (top.first > cost[top.second]) continue;
    if (top.second == last) return;  // all that its way leads through is final
    const int column = static_cast<int>(top.second % width);
    const int row = static_cast<int>(top.second / width);
    for (std::size_t k = 0; k < 8; ++k) {
      const int c = column + kColumnStep[k];
      const int r = row + kRowStep[k];
      if (!map_.inside(c, r)) continue;
      const double distance = field.at_cell(c, r);
      if (distance < clearance.robot_radius) continue;
      const double step = map_.resolution * (k % 2 == 0 ? 1.0 : std::sqrt(2.0));
      const double price = step * (1.0 + clearance.weight * inflation_cost(distance, clearance));
      const float total = top.first + static_cast<float>(price);
      const std::size_t index = map_.index(c, r);
      if (total >= cost[index]) continue;
      cost[index] = total;
      toward_goal_[index] = opposite(k);
      open.emplace(total, static_cast<std::uint32_t>(index));
    }
  }
}

bool GridRoute::reached(int column, int row) const {
  return map_.inside(column, row) && toward_goal_[map_.index(column, row)] != kNone;
}

bool GridRoute::find_start(int& column, int& row) const {
  const int reach = static_cast<int>(std::ceil(kStartTolerance / map_.resolution));
  int nearest = reach * reach + 1;  // [cells^2]
  const int column0 = column;
  const int row0 = row;
  for (int dr = -reach; dr <= reach; ++dr) {
    for (int dc = -reach; dc <= reach; ++dc) {
      if (dr * dr + dc * dc >= nearest || !reached(column0 + dc, row0 + dr)) continue;
      nearest = dr * dr + dc * dc;
      column = column0 + dc;
      row = row0 + dr;
    }
  }
  return nearest <= reach * reach;
}

Route GridRoute::from(const Eigen::Vector2d& start) const {
  int column = map_.column(start.x());
  int row = map_.row(start.y());
  Route route;
  if (!find_start(column, row)) return route;
  for (;;) {
    route.emplace_back(map_.center_x(column), map_.center_y(row));
    const std::uint8_t direction = toward_goal_[map_.index(column, row)];
    if (direction == kGoal) return route;
    column += kColumnStep[direction];
    row += kRowStep[direction];
  }
}

double length(const Route& route) {
  double sum = 0.0;
  for (std::size_t i = 1; i < route.size(); ++i) sum += (route[i] - route[i - 1]).norm();
  return sum;
}

Route resampled(const Route& route, double spacing) {
  Route result;
  double due = 0.0;  // [m], from route[i - 1] to the next point
  for (std::size_t i = 1; i < route.size(); ++i) {
    const Eigen::Vector2d step = route[i] - route[i - 1];
    const double norm = step.norm();
    for (; due < norm; due += spacing) result.push_back(route[i - 1] + step * (due / norm));
    due -= norm;
  }
  if (!route.empty()) result.push_back(route.back());
  return result;
}

}  // namespace sim
}  // namespace hidwa_local_planner
