// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "spec.hpp"
#include "world.hpp"

namespace hidwa_attack {

/// Deeper than this is a touch [m].
constexpr double kTouch = 1e-4;

/// Watches a robot that began free for touches.
class ContactWatch {
 public:
  ContactWatch(const World& world, const Shape& padded_shape);

  /// Each millisecond; a look is taken only when the robot has moved so far that something may have changed.
  void observe(int now, const Pose2& pose, const Twist2& velocity);
  bool touched() const { return deepest_ > kTouch; }
  double deepest_touch() const { return deepest_ > 0.0 ? deepest_ : 0.0; }  // [m]
  int touched_at() const { return touched_at_; }                            // [ms]
  /// Minus the distance to the nearest cell, or the depth [m], at the last look.
  double depth_now() const { return depth_; }

 private:
  void look(int now, const Pose2& pose);

  const World& world_;
  Shape shape_;
  double outermost_;       // [m]
  double moved_ = 1e9;     // of any of its points since the last look, at most [m]
  double depth_ = -1.0;    // at the last look; minus the distance to the nearest cell where it is clear [m]
  double deepest_ = -1.0;  // [m]
  int touched_at_ = -1;    // [ms]
};

}  // namespace hidwa_attack
