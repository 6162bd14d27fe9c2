// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/obstacles.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {

VelocityLimits Obstacles::find_overlaps(const Cycle& cycle) {
  escape_.look(cycle.parameters, cycle.grid, cycle.footprint, cycle.start);
  return escape_.overlaps() ? escape_.slowed() : cycle.start.limits;
}

Obstacles::Reach Obstacles::reach_of(const Cycle& cycle, const Rollout& rollout) {
  const GridView& grid = cycle.grid;
  const double fastest = std::max(cycle.start.pending->fastest().v, rollout.fastest());
  const double manoeuvres = BrakingCheck::reach_of_manoeuvres(cycle.start, fastest);
  const double radius = cycle.footprint.circumscribed_radius();
  const double growth = cycle.start.most_drift(radius, manoeuvres);
  // Nothing lies beyond the map's edge but more of it.
  const double across = std::hypot(grid.size_x, grid.size_y) * grid.resolution + radius;
  Reach reach;
  reach.all = std::min(std::max(rollout.fastest() * rollout.sim_time(), manoeuvres + growth), across);
  // Half a step: what lies between two clear poses is clear. And enough for the poses of a manoeuvre.
  reach.margin = std::max(0.5 * rollout.longest_step(), grid.resolution / 16.0);
  reach.clearance = std::min(growth + 2.0 * grid.resolution, across);
  return reach;
}

void Obstacles::prepare(const Cycle& cycle, const Rollout& rollout, const ComfortTurn& comfort, bool steered,
                        bool turn_out) {
  const Reach reach = reach_of(cycle, rollout);
  collision_.prepare(cycle.grid, cycle.footprint, cycle.parameters.unknown_is_obstacle, cycle.start.pose, reach.all,
                     reach.margin, reach.clearance);
  if (escape_.applies()) escape_.prepare(reach.all, reach.margin, reach.clearance);
  admissibility_.prepare(
      cycle.parameters, escape_.applies() ? escape_.rest() : collision_, cycle.footprint, cycle.grid.resolution,
      {&cycle.start, turn_out, steered, escape_.applies() ? &escape_ : nullptr, comfort, cycle.movers, cycle.hidden});
}

}  // namespace hidwa_local_planner
