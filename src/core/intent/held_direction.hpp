// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// The direction that the operator means while they drive without a goal. It begins as the robot's heading, and turns
/// as fast as the operator command does. While the robot drives round an obstacle it stays: so the robot comes back to
/// it. It begins anew where the operator steers otherwise than before: they have seen where the robot heads.
class HeldDirection {
 public:
  /// The robot's heading stays within this of the direction [rad]: along a wall that is met at 30 degrees, and a little
  /// more to keep clear of it.
  static constexpr double kMost = 0.55;

  void forget() { held_ = false; }
  /// Once a cycle. `heading` of the robot [rad], the operator command, the time since the cycle before [s], and the
  /// fastest turn [rad/s]. Returns the robot's heading less the direction [rad].
  double update(double heading, const Twist2& wanted, double elapsed, double fastest_turn) {
    const bool other = wanted.v * begun_.v <= 0.0 || std::abs(wanted.omega - begun_.omega) > kOther * fastest_turn;
    if (!held_ || other) {
      held_ = true;
      begun_ = wanted;
      direction_ = heading;
      return 0.0;
    }
    const double off = wrap_angle(heading - direction_ - wanted.omega * elapsed);
    const double within = std::clamp(off, -kMost, kMost);
    direction_ = wrap_angle(heading - within);
    return within;
  }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.held_, self.begun_, self.direction_);
  }

 private:
  static constexpr double kOther = 0.15;  // a change of the wanted turn, as a share of the fastest one

  bool held_ = false;
  Twist2 begun_;            // the operator command when it began [m/s, rad/s]
  double direction_ = 0.0;  // costmap frame [rad]
};

}  // namespace hidwa_local_planner
