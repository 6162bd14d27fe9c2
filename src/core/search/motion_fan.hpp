// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/motion/velocity_limits.hpp"
#include "core/util/rotation.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// What a robot does if it goes from one state to each of some velocities within its limits and keeps it, in a few
/// equal steps. Motions share speeds and turns: those are rolled out once, and each motion is put together of the two.
class MotionFan {
 public:
  static constexpr std::size_t kSteps = 4;

  /// An axis' share of a motion, step by step.
  struct Speed {
    double target = 0.0;             // [m/s]
    std::array<double, kSteps> way;  // of each step [m]
    std::array<double, kSteps> v;    // after it [m/s]
  };
  struct Turn {
    double target = 0.0;                   // [rad/s]
    std::array<Rotation, kSteps> middle;   // heading in the middle of each step
    std::array<Rotation, kSteps> heading;  // after it
    double last = 0.0;                     // after the last step [rad/s]
  };

  MotionFan();
  void clear();
  /// One more motion [m/s, rad/s].
  void add(const Twist2& motion);
  std::size_t size() const { return motions_.size(); }
  Twist2 motion(std::size_t i) const { return {speed(i).target, turn(i).target}; }

  /// From a heading and a velocity [m/s, rad/s] on, in steps of `step` [s].
  void unfold(const VelocityLimits& limits, const Rotation& heading, const Twist2& velocity, double step);
  const Speed& speed(std::size_t i) const { return speeds_[motions_[i].speed]; }
  const Turn& turn(std::size_t i) const { return turns_[motions_[i].turn]; }

 private:
  struct Motion {
    std::size_t speed, turn;
  };
  std::vector<Speed> speeds_;
  std::vector<Turn> turns_;
  std::vector<Motion> motions_;
};

}  // namespace hidwa_local_planner
