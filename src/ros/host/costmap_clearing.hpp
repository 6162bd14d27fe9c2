// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <costmap_2d/costmap_2d_ros.h>

namespace hidwa_local_planner {

/// Forgets what layers of `costmap` marked outside a square of `side` [m] around the robot; what sensors still see
/// comes back with their next messages. `layers`: their names without namespace; none: every obstacle layer. Returns
/// the names of those cleared; none, with the reason in `fault`, where the robot's pose cannot be had or no layer is
/// meant.
std::vector<std::string> clear_far_from_robot(costmap_2d::Costmap2DROS& costmap, double side,
                                              const std::vector<std::string>& layers, std::string& fault);

}  // namespace hidwa_local_planner
