// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "sim/diff_drive.hpp"
#include "sim/random.hpp"

namespace hidwa_local_planner {
namespace sim {

/// How wrong the wheels' odometry is: what it reports is (1 + slip) times what was driven, the slip of each
/// axis drawn anew from a normal distribution every `slip_period`.
struct OdometryNoise {
  double slip_x = 0.0;       // standard deviation, share of the distance
  double slip_theta = 0.0;   // standard deviation, share of the angle
  double slip_period = 0.5;  // [s]
};

/// Odometry as the wheels report it: starts at the origin of its frame and drifts with the slip.
class Odometry {
 public:
  Odometry(const OdometryNoise& noise, std::uint64_t seed);

  /// What was truly driven within `dt` [s], and the true velocity at its end.
  void step(const Motion& motion, const Velocity& velocity, double dt);

  const Pose& pose() const { return pose_; }
  const Velocity& velocity() const { return velocity_; }

 private:
  OdometryNoise noise_;
  Random random_;
  Pose pose_;
  Velocity velocity_;
  double slip_age_ = 0.0;  // [s]
  double slip_x_ = 0.0;
  double slip_theta_ = 0.0;
};

}  // namespace sim
}  // namespace hidwa_local_planner
