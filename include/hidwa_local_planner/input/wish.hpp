// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner::input {

/// What a person asks for in one message, whatever the device: each kind of device has a source that turns
/// its messages into wishes, and everything behind the sources knows wishes only.
struct Wish {
  bool active = false;  // the person gives input
  Twist2 u_h;           // wanted velocity while active, unclipped [m/s, rad/s]
};

}  // namespace hidwa_local_planner::input
