// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "attack/world.hpp"
#include "ways/body.hpp"

namespace hidwa_ways {

using hidwa_attack::World;

/// A piece of a way: a line (no turn), a turn on the spot (no length) or an arc.
struct Move {
  double length = 0.0;  // [m]; backwards negative
  double turn = 0.0;    // [rad], counter-clockwise
};

/// The pose after `share` in [0, 1] of a move.
Pose2 after(const Pose2& from, const Move& move, double share = 1.0);

/// How fast a robot is that follows a way.
struct Pace {
  double forward = 0.5;   // [m/s]
  double backward = 0.0;  // [m/s]
  double turning = 1.0;   // [rad/s]
};

/// From a pose by one move after the other.
struct Way {
  Pose2 start;
  std::vector<Move> moves;

  double length() const;                                      // forwards and backwards [m]
  double time(const Pace& pace) const;                        // at the limits, without ramps [s]
  std::vector<Pose2> poses(double step, double angle) const;  // no farther apart than that [m], [rad]
};

/// The slow check of a way, by separating axes in steps of 1 mm and 0.1 degrees: the deepest that the shape lies in a
/// lethal cell [m]; negative where it touches none.
double deepest_along(const Way& way, const World& world, const Shape& shape);

}  // namespace hidwa_ways
