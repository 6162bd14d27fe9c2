// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kLongestReach = 255;  // [cells]

/// A ray along one axis, in cells.
struct Axis {
  double start;
  double direction;
  double length_per_cell;  // along the ray
  int cell;

  Axis(double from, double along)
      : start(from),
        direction(along),
        length_per_cell(along == 0.0 ? kInfinity : 1.0 / along),
        cell(static_cast<int>(std::floor(from))) {}

  /// Length along the ray to the border of the cells nearer than `reach`.
  double leaves(int reach) const {
    if (direction == 0.0) return kInfinity;
    return ((direction > 0.0 ? cell + reach : cell - reach + 1) - start) * length_per_cell;
  }
  void leap(int reach) { cell += direction > 0.0 ? reach : -reach; }
  void follow(double length, int reach) {
    const int at = static_cast<int>(std::floor(start + length * direction));
    cell = std::clamp(at, cell - reach + 1, cell + reach - 1);
  }
};

/// Distance to the nearest occupied cell in king's moves: exact in one pass down and one back.
std::vector<std::uint8_t> kings_distance(const OccupancyMap& map) {
  std::vector<std::uint8_t> distance(map.cells.size(), static_cast<std::uint8_t>(kLongestReach));
  const auto lower = [&](int column, int row, int nearby_column, int nearby_row) {
    if (!map.inside(nearby_column, nearby_row)) return;
    const int through = distance[map.index(nearby_column, nearby_row)] + 1;
    std::uint8_t& here = distance[map.index(column, row)];
    if (through < here) here = static_cast<std::uint8_t>(through);
  };
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (map.occupied(column, row)) distance[map.index(column, row)] = 0;
      lower(column, row, column - 1, row);
      for (int d = -1; d <= 1; ++d) lower(column, row, column + d, row - 1);
    }
  }
  for (int row = map.height - 1; row >= 0; --row) {
    for (int column = map.width - 1; column >= 0; --column) {
      lower(column, row, column + 1, row);
      for (int d = -1; d <= 1; ++d) lower(column, row, column + d, row + 1);
    }
  }
  return distance;
}

}  // namespace

RayCaster::RayCaster(const OccupancyMap& map) : map_(map), reach_(kings_distance(map)) { map_.cells = {}; }

int RayCaster::free_reach(int column, int row) const {
  return map_.inside(column, row) ? reach_[map_.index(column, row)] : 1;
}

double RayCaster::range(double x, double y, double angle, double range_max) const {
  Axis column((x - map_.origin_x) / map_.resolution, std::cos(angle));
  Axis row((y - map_.origin_y) / map_.resolution, std::sin(angle));
  const double longest = range_max / map_.resolution;  // [cells]
  double length = 0.0;                                 // [cells]
  while (length <= longest) {
    const int reach = free_reach(column.cell, row.cell);
    if (reach == 0) return length * map_.resolution;
    const double column_exit = column.leaves(reach);
    const double row_exit = row.leaves(reach);
    if (column_exit < row_exit) {
      length = column_exit;
      column.leap(reach);
      row.follow(length, reach);
    } else {
      length = row_exit;
      row.leap(reach);
      column.follow(length, reach);
    }
  }
  return kInfinity;
}

}  // namespace sim
}  // namespace hidwa_local_planner
