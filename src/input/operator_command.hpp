// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::input {

/// What an input device asks for now, whatever kind of device it is.
struct OperatorCommand {
  bool active = false;  // the operator gives input: the device is deflected, or its enable button is held
  Twist2 u_h;           // the operator command while active, not clipped to the limits [m/s, rad/s]
};

}  // namespace hidwa_local_planner::input
