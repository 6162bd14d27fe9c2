// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "attack/random.hpp"
#include "attack/world.hpp"
#include "ways/body.hpp"

namespace hidwa_ways {

using hidwa_attack::Random;
using hidwa_attack::World;

/// A world, and the place in it that matters: a gap, a corner, a pocket.
struct Site {
  World world;
  Spot at;              // [m]
  double around = 1.2;  // the robot starts no farther from it than that [m]
  bool passed = false;  // the plan is to lead by it
};

/// Half the width of the robot's narrowest gap, and a map's resolution [m].
struct Measure {
  double half_width = 0.25;
  double resolution = 0.05;
};

}  // namespace hidwa_ways
