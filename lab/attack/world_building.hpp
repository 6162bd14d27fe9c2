// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random.hpp"
#include "shape.hpp"
#include "world.hpp"

namespace hidwa_attack {

enum class Place { posts, walls, corridor, dead_ends, clutter, open };
const char* name_of(Place place);

/// Where a drive happens, and where it begins.
struct Scenery {
  World world;
  Pose2 start;
};

/// A square of at most `size` [m] cut out of a ground about a free place of it, the nearer to obstacles the likelier;
/// what lies beyond the ground is lethal. Throws std::invalid_argument where the robot fits nowhere.
Scenery cut(const World& ground, double size, const Shape& shape, Random& random);

/// A walled square of `size` [m] with random obstacles, and a start at least 3 cm from all of them.
Scenery build(Place place, double size, double resolution, const Shape& shape, Random& random);

}  // namespace hidwa_attack
