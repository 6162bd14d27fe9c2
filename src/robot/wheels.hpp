// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "robot/model.hpp"

namespace hidwa_local_planner::robot {

/// The two driving wheels of a differential drive.
struct Wheels {
  std::string left, right;    // their joints
  double separation = 0.0;    // across y [m]
  double radius = 0.0;        // the smaller of both [m]; 0: their geometry has none
  std::string no_radius;      // then: why, and the remedy
  double max_velocity = 0.0;  // the smaller limit of both joints [rad/s]; 0: they have none
  std::string slower;         // the joint that has it
};

struct WheelSearch {
  std::optional<Wheels> wheels;
  std::string fault;       // why there are none: names the joint and the remedy
  bool undecided = false;  // nothing is wrong, but the joints must be named
};

/// The wheels on the joints `left` and `right`. Both empty: the one pair of joints that turn freely about y,
/// opposite each other across the base's x axis and carried by nothing that moves. Radius: of the child
/// link's cylinder along the axis or sphere, collision before visual geometry.
WheelSearch find_wheels(const Model& model, const std::string& left, const std::string& right);

}  // namespace hidwa_local_planner::robot
