// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::control {

/// Whether a lethal cell's centre lies inside the closed line (costmap frame, closed implicitly): where its winding
/// number is not zero. The line may cross itself.
bool encloses_obstacle(const std::vector<Point>& line, const GridView& costmap);

}  // namespace hidwa_local_planner::control
