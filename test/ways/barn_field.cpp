// SPDX-License-Identifier: BSD-3-Clause
#include "ways/barn_field.hpp"

#include "ways/drawing.hpp"

namespace hidwa_ways {

using hidwa_local_planner::sim::BarnWorld;

Site barn(const std::vector<BarnWorld>& worlds, const Measure& measure, Random& random) {
  constexpr double kAround = 0.8;  // free around a field [m]
  const BarnWorld& world = worlds[static_cast<std::size_t>(random.whole(0, static_cast<int>(worlds.size()) - 1))];
  Eigen::Vector2d low = world.cylinders.front(), high = low;
  for (const Eigen::Vector2d& p : world.cylinders) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double width = high.x() - low.x() + 2.0 * kAround, height = high.y() - low.y() + 2.0 * kAround;
  Site site{World(width, height, measure.resolution), {}, 1.5, false};
  for (const Eigen::Vector2d& p : world.cylinders) {
    const Spot middle{p.x() - low.x() + kAround, p.y() - low.y() + kAround};
    fill_disc(site.world, middle, hidwa_local_planner::sim::kBarnCylinder, true);
  }
  wall_in(site.world);
  site.at = {random.in(0.25, 0.75) * width, random.in(0.15, 0.85) * height};
  return site;
}

}  // namespace hidwa_ways
