// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <ros/node_handle.h>

#include "tracking/tracker_settings.hpp"

namespace hidwa_local_planner {
namespace tracking {

/// Parameters of hidwa_tracker, all private to it.
struct NodeParameters {
  TrackerSettings tracker;
  std::string fixed_frame = "odom";  // obstacles are told in it; it must not jump
  double transform_timeout = 0.3;    // how long a scan waits for its transform [s]
  double lag_max = 0.3;              // a scan that is used later than this is told in the diagnostics [s]
};

/// Throws std::runtime_error that names the parameter at fault, and what it must be.
NodeParameters read_node_parameters(const ros::NodeHandle& node);

}  // namespace tracking
}  // namespace hidwa_local_planner
