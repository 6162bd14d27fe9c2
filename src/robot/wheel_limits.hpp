// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"
#include "robot/wheels.hpp"

namespace hidwa_local_planner::robot {

/// What is worth saying about one limit.
struct Remark {
  enum class Level { info, warning, fault };
  Level level = Level::info;
  std::string subject;  // the same for as long as the same side holds, whatever the numbers
  std::string text;
};

struct LimitedParameters {
  Parameters parameters;
  std::vector<Remark> remarks;
};

/// The parameters of a robot with these wheels; where both limit something, the tighter one holds.
/// wheel_separation of the parameters describes the same robot: where it is set it counts, and more than 2 % between it
/// and the URDF is a warning. The wheel speed s is the smaller of max_wheel_speed and the joints' limit times the
/// radius. With it and the separation d, max_vel_x and min_vel_x come down to s, max_vel_theta to 2 s / d, and the
/// corners of the window are cut by the wheel parameters. Where s is known to neither side, or a parameter is out of
/// its range, the parameters stay as they are.
LimitedParameters limited(const Parameters& wanted, const Wheels& wheels);

}  // namespace hidwa_local_planner::robot
