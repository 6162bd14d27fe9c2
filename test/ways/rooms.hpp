// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ways/site.hpp"

namespace hidwa_ways {

/// Walled rooms of 12 m with random obstacles; measures about those of the robot.
Site posts(const Measure& measure, Random& random);
Site boxes(const Measure& measure, Random& random);
/// A pocket with three walls, in which the robot starts.
Site dead_end(const Measure& measure, Random& random);
/// A wall across the room, with a gap from a little too narrow to comfortable.
Site doorway(const Measure& measure, Random& random);
/// Cut out of solid walls, with a bend.
Site corridor(const Measure& measure, Random& random);
/// Of a large block, with something opposite.
Site corner(const Measure& measure, Random& random);

}  // namespace hidwa_ways
