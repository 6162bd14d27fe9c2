// SPDX-License-Identifier: BSD-3-Clause
// A proof that there is no way.
//
// 1. All poses are divided into the lattice's cells. A cell counts as passable where the outline, smaller on every side
//    by what any point of it can be displaced within a cell, is free at the cell's middle.
// 2. From a cell lead its neighbours in heading, and those in position to which the robot's heading can lead: a robot
//    that only drives forwards gets from x to a larger x only with a heading whose cosine is positive.
// 3. Every cell that can be reached is looked at. The target is as wide as a drive may miss it.
//
// Right because a way passes from cell to neighbouring cell; each of these holds a free pose, so that the smaller
// outline is free at its middle. Where not even this search comes through, nothing does. Where it does, nothing is
// said.
#pragma once

#include "ways/lattice.hpp"
#include "ways/target.hpp"

namespace hidwa_ways {

bool surely_no_way(const Ground& ground, const Lattice& lattice, const Shape& shape, bool reverse, const Pose2& start,
                   const Target& target, double tolerance);

}  // namespace hidwa_ways
