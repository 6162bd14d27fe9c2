// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "sim/barn_world.hpp"
#include "ways/site.hpp"

namespace hidwa_ways {

/// A place in the midst of the field of one of these worlds.
Site barn(const std::vector<hidwa_local_planner::sim::BarnWorld>& worlds, const Measure& measure, Random& random);

}  // namespace hidwa_ways
