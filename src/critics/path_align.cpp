// SPDX-License-Identifier: BSD-3-Clause
#include "critics/path_align.hpp"

namespace hidwa_local_planner {

double PathAlignCritic::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  distance_ = parameters.map_grid;
  forward_ = parameters.PathAlign_forward_point_distance;
  return 0.5 * parameters.PathAlign_scale;
}

const DistanceGrid* PathAlignCritic::choose(const CycleView& cycle) {
  // At the goal the nose lies beyond the path's end: it would push the robot back.
  if (distance(cycle.pose, cycle.goal) <= forward_) return nullptr;
  return &cycle.grids->to_path();
}

}  // namespace hidwa_local_planner
