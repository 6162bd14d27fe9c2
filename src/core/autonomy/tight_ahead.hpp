// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/collision/collision.hpp"
#include "core/util/rotation.hpp"
#include "hidwa_local_planner/core/tile.hpp"

namespace hidwa_local_planner {

/// Whether the robot comes nearer than a cell to something on a rollout, in the next `duration` [s]. `checker` is
/// prepared for it.
inline bool tight_ahead(const CollisionChecker& checker, const Tile& tile, std::size_t c, double duration,
                        double resolution) {
  for (std::size_t k = 0; k <= tile.steps && static_cast<double>(k) * tile.dt <= duration; ++k) {
    if (checker.clear_around(tile.x_at(k, c), tile.y_at(k, c), resolution)) continue;
    const Rotation heading{tile.cos_heading[k], tile.sin_heading[k]};
    if (checker.clearance(tile.pose(k, c), heading, resolution) < resolution) return true;
  }
  return false;
}

/// The last pose of a rollout that the robot comes to within `time` [s].
inline Pose2 pose_within(const Tile& tile, std::size_t c, double time) {
  return tile.pose(std::min(static_cast<std::size_t>(time / tile.dt), tile.steps), c);
}

}  // namespace hidwa_local_planner
