// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "hidwa_local_planner/core/decision.hpp"
#include "hidwa_local_planner/core/operator_intent.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

struct VelocityLimits;

/// What to do while an input is missing (transform, plan, odometry or costmap). A robot that moves brakes from the last
/// command, as the planner brakes (VelocityLimits::brake()); that counts as success. A robot that stands fails, so that
/// the host replans or recovers. Without odometry the robot counts as moving until v_max / deceleration plus one period
/// have passed and the command has reached 0.
class FaultBrake {
 public:
  struct Command {
    bool success = false;
    Twist2 command;  // [m/s, rad/s]
  };
  /// `velocity`: measured, where odometry is at hand. `limits`: of the parameters. `now` and `period` [s].
  Command brake(double now, const std::optional<Twist2>& velocity, const Twist2& last_command,
                const Parameters& parameters, const VelocityLimits& limits, double period);
  /// The input is complete again.
  void clear() { since_.reset(); }
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.since_);
  }

 private:
  std::optional<double> since_;  // when the input went missing [s]
};

/// What its command means to the host. While the operator stops the robot it holds: the host must not recover then.
Outcome outcome_of(const FaultBrake::Command& braking, const OperatorIntent& intent);

}  // namespace hidwa_local_planner
