// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"
#include "sim/barn_world.hpp"
#include "support/random.hpp"

namespace hidwa_local_planner::test {

/// Something to drive through.
struct Course {
  static constexpr double kSpacing = 0.05;  // of the path's poses [m]

  std::vector<Point> obstacles;  // points that make their cells lethal, as laser returns do [m]
  std::vector<Pose2> path;       // kSpacing apart, headings along it
  std::size_t first = 0;         // the robot may stand at path[first] to path[last]
  std::size_t last = 0;
};

/// A straight corridor 2 to 3 m wide in any direction.
Course open_corridor(Random& random);

/// The field's reference path, from 2 m before the field to 3.5 m beyond it.
Course barn_course(const sim::BarnWorld& world);

}  // namespace hidwa_local_planner::test
