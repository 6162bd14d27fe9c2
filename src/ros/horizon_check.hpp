// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"

namespace hidwa_local_planner {

struct AxisLimits;

/// Whether the planner looks far enough ahead to stop: sim_time against v_max / deceleration + latency, and
/// half the local map against v_max sim_time + circumscribed radius. Each complaint names the remedy.
/// `x`: the limits of driving, see Planner::limits(). `map_width`, `map_height` [m] of the local costmap;
/// `circumscribed_radius` [m] of the footprint.
std::vector<std::string> horizon_complaints(const Parameters& parameters, const AxisLimits& x, double map_width,
                                            double map_height, double circumscribed_radius);

}  // namespace hidwa_local_planner
