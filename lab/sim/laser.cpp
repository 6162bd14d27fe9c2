// SPDX-License-Identifier: BSD-3-Clause
#include "sim/laser.hpp"

#include <cmath>
#include <limits>

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A field of distances counts from centre to centre. From any point of a cell to any point of another one it is up to
// two half diagonals less, sqrt(2), rounded up here [cells].
constexpr double kDiagonal = 1.5;

/// A ray along one axis, in cells.
struct Axis {
  Axis(double from, double along)
      : start(from), direction(along), length_per_cell(1.0 / along), cell(static_cast<int>(std::floor(from))) {}

  /// Length along the ray to the border of its cell.
  double leaves() const {
    return direction == 0.0 ? kInfinity : ((direction > 0.0 ? cell + 1 : cell) - start) * length_per_cell;
  }

  void step() { cell += direction > 0.0 ? 1 : -1; }
  void follow(double length) { cell = static_cast<int>(std::floor(start + length * direction)); }

  double start;
  double direction;
  double length_per_cell;  // along the ray
  int cell;
};

}  // namespace

double LaserSpec::angle_increment() const {
  const bool full_turn = field_of_view > 2.0 * M_PI - 1e-6;
  return beams > 1 ? field_of_view / (full_turn ? beams : beams - 1) : field_of_view;
}

void scan(const std::function<double(double angle)>& range_at, const LaserSpec& spec, double sensor_heading,
          Random& random, std::vector<float>& ranges) {
  ranges.clear();
  const double increment = spec.angle_increment();
  for (int i = 0; i < spec.beams; ++i) {
    const double angle = sensor_heading + spec.angle_min() + i * increment;
    double range = range_at(angle);
    if (spec.noise > 0.0 && std::isfinite(range)) range += spec.noise * random.normal();
    if (range > spec.range_max) range = kInfinity;
    if (range < spec.range_min) range = -kInfinity;
    ranges.push_back(static_cast<float>(range));
  }
}

double range_in(const OccupancyMap& map, double x, double y, double angle, double range_max,
                const DistanceField* to_obstacles) {
  Axis column((x - map.origin_x) / map.resolution, std::cos(angle));
  Axis row((y - map.origin_y) / map.resolution, std::sin(angle));
  const double cells_per_metre = 1.0 / map.resolution;
  const double longest = range_max / map.resolution;  // [cells]
  double length = 0.0;                                // [cells]
  while (length <= longest) {
    if (map.occupied(column.cell, row.cell)) return length * map.resolution;
    const bool known = to_obstacles != nullptr && map.inside(column.cell, row.cell);
    const double free = known ? to_obstacles->at_cell(column.cell, row.cell) * cells_per_metre - kDiagonal : 0.0;
    if (free > 1.0) {
      length += free;
      column.follow(length);
      row.follow(length);
      continue;
    }
    Axis& nearer = column.leaves() < row.leaves() ? column : row;
    length = nearer.leaves();
    nearer.step();
  }
  return kInfinity;
}

}  // namespace sim
}  // namespace hidwa_local_planner
