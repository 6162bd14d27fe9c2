// SPDX-License-Identifier: BSD-3-Clause
#include "drive/local_costmap.hpp"

#include <utility>

#include "hidwa_local_planner/core/footprint.hpp"

namespace hidwa_local_planner {
namespace drive {

LocalCostmap::LocalCostmap(const CostmapSettings& settings, Polygon outline)
    : settings_(settings),
      outline_(std::move(outline)),
      obstacles_(settings.width, settings.resolution),
      costs_(settings.width, settings.resolution),
      inflation_(settings.inflation, Footprint(outline_).inscribed_radius(), settings.resolution) {}

void LocalCostmap::update(const sim::Pose& robot, const Beams& beams) {
  obstacles_.follow(robot.x, robot.y);
  clear_along(beams, settings_.raytrace_range, obstacles_);
  mark_ends(beams, settings_.obstacle_range, obstacles_);
  clear_polygon(sim::transformed(outline_, robot), obstacles_);
  costs_.take_place_of(obstacles_);
  inflation_.inflate(obstacles_, costs_);
}

}  // namespace drive
}  // namespace hidwa_local_planner
