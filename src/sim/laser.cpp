// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/sim/laser.hpp"

#include <cmath>
#include <limits>

namespace hidwa_local_planner {
namespace sim {

double LaserSpec::angle_increment() const {
  const bool full_turn = field_of_view > 2.0 * M_PI - 1e-6;
  return beams > 1 ? field_of_view / (full_turn ? beams : beams - 1) : field_of_view;
}

void scan(const RayCaster& caster, const LaserSpec& spec, const Pose& sensor, Random& random,
          std::vector<float>& ranges) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ranges.clear();
  const double increment = spec.angle_increment();
  for (int i = 0; i < spec.beams; ++i) {
    const double angle = sensor.theta + spec.angle_min() + i * increment;
    double range = caster.range(sensor.x, sensor.y, angle, spec.range_max);
    if (spec.noise > 0.0 && std::isfinite(range)) range += spec.noise * random.normal();
    if (range > spec.range_max) range = kInfinity;
    if (range < spec.range_min) range = -kInfinity;
    ranges.push_back(static_cast<float>(range));
  }
}

}  // namespace sim
}  // namespace hidwa_local_planner
