// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "random.hpp"
#include "world.hpp"

namespace hidwa_attack {

/// Sets one to three cells that a robot at this pose overlaps, each by a millimetre to 15 cm.
void put_stray_cells(World& world, const Shape& padded_shape, const Pose2& pose, Random& random);

/// Sets up to a dozen cells around it, 1 to 40 cm from its outline.
void put_cells_around(World& world, const Shape& padded_shape, const Pose2& pose, Random& random);

/// A pose that stands in an obstacle by 2 mm to a cell and a half; `fallback` where none is found.
Pose2 grazing_pose(const World& world, const Shape& padded_shape, const Pose2& fallback, Random& random);

}  // namespace hidwa_attack
