// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/input/stick_message.hpp"
#include "hidwa_local_planner/input/wish.hpp"

namespace hidwa_local_planner::input {

/// Where a stick stands, in the planner's directions.
struct StickReading {
  float angular = 0.0F;  // left positive, about [-1, 1]
  float linear = 0.0F;   // forward positive, about [-1, 1]; 0 where the device does not have the axis
  bool enabled = false;  // the enable button is held; false where none is configured
};

/// Reads a message by the parameters axis_*, enable_button and linear. Returns the fault in words, naming the
/// remedy, and leaves `reading` alone when the message cannot be used: a value that is not a number anywhere
/// in it, an axis or button that is needed and that it does not have, or one out of range. The linear axis is
/// needed with `linear: axis`.
std::string read_stick(const StickMessage& message, const Parameters& parameters, StickReading& reading);

/// What a reading asks for (Kalliokoski 2022, section IV-A, SJ): u_h = (max_vel_x, map(angular)), or with
/// `linear: axis` (map(linear), map(angular)). Active while the mapped command is not zero; where there is an
/// enable button, while that is held: a centred stick then means straight on.
Wish wish_of(const StickReading& reading, const Parameters& parameters);

}  // namespace hidwa_local_planner::input
