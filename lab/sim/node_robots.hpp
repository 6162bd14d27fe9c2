// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include <ros/node_handle.h>

#include "sim/mover.hpp"

namespace hidwa_local_planner {
namespace sim {

/// `people`, and the other simulated robots that the private parameters name: ~robots, a list of topics with their true
/// poses (nav_msgs/Odometry in the map frame, as ground_truth), and ~robots_radius [m]. Each is a round body. Without
/// robots it is `people`, which may be null. Throws std::runtime_error naming the parameter at fault.
std::shared_ptr<People> with_robots(const ros::NodeHandle& node, std::shared_ptr<People> people);

}  // namespace sim
}  // namespace hidwa_local_planner
