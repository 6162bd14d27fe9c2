// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random.hpp"
#include "shape.hpp"
#include "world.hpp"

namespace hidwa_attack {

enum class Place { posts, walls, corridor, dead_ends, clutter };
const char* name_of(Place place);

/// Where a drive happens, and where it begins.
struct Scenery {
  World world;
  Pose2 start;
};

/// A walled square of `size` [m] with random obstacles, and a start at least 3 cm from all of them.
Scenery build(Place place, double size, double resolution, const Shape& shape, Random& random);

}  // namespace hidwa_attack
