// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "attack/world.hpp"
#include "ways/body.hpp"

namespace hidwa_ways {

using hidwa_attack::World;

/// Sets or clears the cells whose middle lies in a box of this length along its pose's heading [m].
void fill_box(World& world, const Pose2& middle, double length, double width, bool lethal);
/// The same for a disc [m].
void fill_disc(World& world, const Spot& middle, double radius, bool lethal);
/// A border two cells thick.
void wall_in(World& world);

/// The place `by` [m] from another in a direction [rad].
Spot farther(const Spot& from, double direction, double by);

}  // namespace hidwa_ways
