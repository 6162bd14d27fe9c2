// SPDX-License-Identifier: BSD-3-Clause
#include "sim/silhouettes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace sim {
namespace {

constexpr double kBriskWalk = 1.2;  // [m/s], the swing is full from here on

void add_legs(const Mover& person, std::size_t index, std::vector<Silhouettes::Disc>& discs) {
  const Eigen::Vector2d ahead(std::cos(person.heading), std::sin(person.heading)), left(-ahead.y(), ahead.x());
  const double swing = kLegSwing * std::min(1.0, person.velocity.norm() / kBriskWalk) * std::sin(person.gait);
  discs.push_back({person.position + 0.5 * kLegSpacing * left + swing * ahead, kLegRadius, index});
  discs.push_back({person.position - 0.5 * kLegSpacing * left - swing * ahead, kLegRadius, index});
}

}  // namespace

Silhouettes::Silhouettes(const std::vector<Mover>& movers) {
  for (std::size_t k = 0; k < movers.size(); ++k) {
    if (movers[k].body == Body::legs) {
      add_legs(movers[k], k, discs_);
    } else {
      discs_.push_back({movers[k].position, movers[k].radius, k});
    }
  }
}

Silhouettes::Hit Silhouettes::cast(double x, double y, double angle, double range_max) const {
  Hit hit{std::numeric_limits<double>::infinity(), 0};
  if (discs_.empty()) return hit;
  const double c = std::cos(angle), s = std::sin(angle);
  for (const Disc& disc : discs_) {
    const double range = ray_to_disc(disc.centre - Eigen::Vector2d(x, y), c, s, disc.radius);
    if (range <= range_max && range < hit.range) hit = {range, disc.mover};
  }
  return hit;
}

}  // namespace sim
}  // namespace hidwa_local_planner
