// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/diff_drive.hpp"
#include "sim/grid_route.hpp"
#include "sim/polygon.hpp"

namespace hidwa_local_planner {
namespace sim {

/// Where the stick stands, signs as joy_node has them.
struct Stick {
  double left = 0.0;  // -1 to 1, left positive
  double up = 0.0;    // -1 to 1, up (away from the person) positive
};

/// What the person sees of the robot.
struct Observation {
  double time = 0.0;  // [s]
  Pose pose;          // map frame
  Velocity velocity;
};

/// A person at the stick.
class Operator {
 public:
  virtual ~Operator() = default;

  /// Where the stick stands now; to be asked with times that do not fall.
  virtual Stick update(const Observation& observation) = 0;

  /// The robot's global plan, map frame, whenever there is a new one.
  virtual void set_plan(const Route& /*plan*/) {}
};

/// Leaves the stick alone.
class AbsentOperator : public Operator {
 public:
  Stick update(const Observation&) override { return Stick(); }
};

}  // namespace sim
}  // namespace hidwa_local_planner
