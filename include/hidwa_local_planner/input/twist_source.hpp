// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "hidwa_local_planner/input/wish.hpp"

namespace hidwa_local_planner::input {

/// One velocity that another node made out of a person's input: a keyboard's, or a mapper's.
struct TwistMessage {
  Twist2 u;                 // linear.x [m/s], angular.z [rad/s]
  double stamp = 0.0;       // header stamp [s]; 0 where there is none
  double received = 0.0;    // when it arrived [s]
  std::string sender = {};  // who sent it, where known
};

/// The fault in words where the message cannot be used, since a part is no number or beyond 100 m/s or 100 rad/s;
/// empty where it can.
std::string fault_of(const TwistMessage& message);

/// The message itself is u_h, whatever the linear policy; but in shared control `current` leaves v to the
/// robot's own. Active while it is not zero.
Wish wish_of(const TwistMessage& message, const Parameters& parameters);

}  // namespace hidwa_local_planner::input
