// SPDX-License-Identifier: BSD-3-Clause
#include "critics/path_dist.hpp"

namespace hidwa_local_planner {

double PathDistCritic::configure(const Parameters& parameters, const ParameterSource& /*own*/) {
  distance_ = parameters.map_grid;
  return 0.5 * parameters.PathDist_scale;
}

const DistanceGrid* PathDistCritic::choose(const CycleView& cycle) { return &cycle.grids->to_path(); }

}  // namespace hidwa_local_planner
