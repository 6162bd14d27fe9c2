// SPDX-License-Identifier: BSD-3-Clause
#include "sim/laser.hpp"

#include <cmath>
#include <limits>

namespace hidwa_local_planner {
namespace sim {

double LaserSpec::angle_increment() const {
  const bool full_turn = field_of_view > 2.0 * M_PI - 1e-6;
  return beams > 1 ? field_of_view / (full_turn ? beams : beams - 1) : field_of_view;
}

void scan(const std::function<double(double angle)>& range_at, const LaserSpec& spec, double sensor_heading,
          Random& random, std::vector<float>& ranges) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
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

void scan(const RayCaster& caster, const LaserSpec& spec, const Pose& sensor, Random& random,
          std::vector<float>& ranges) {
  const auto range = [&](double angle) { return caster.range(sensor.x, sensor.y, angle, spec.range_max); };
  scan(range, spec, sensor.theta, random, ranges);
}

}  // namespace sim
}  // namespace hidwa_local_planner
