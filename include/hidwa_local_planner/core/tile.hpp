// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

class EndCells;

/// Candidates that share the rotational sample and the number of steps, and so every heading: one tile, small enough to
/// stay in the first cache while everybody looks at it. Positions are rows a step, columns a candidate; row k = 0 is
/// the start pose. Rows are `stride` apart: what lies beyond `count` is padding.
struct Tile {
  double omega = 0.0;                     // the rotational sample [rad/s]
  double dt = 0.0;                        // length of a step [s]
  std::size_t steps = 0;                  // poses are steps + 1
  std::size_t first = 0;                  // index of the first candidate in the batch's order
  std::size_t count = 0;                  // number of candidates
  std::size_t stride = 0;                 // >= count
  const double* v = nullptr;              // [count] the forward samples [m/s]
  const double* x = nullptr;              // [(steps + 1) * stride] costmap frame [m]
  const double* y = nullptr;              // [(steps + 1) * stride] costmap frame [m]
  const double* heading = nullptr;        // [steps + 1] [rad]
  const double* cos_heading = nullptr;    // [steps + 1]
  const double* sin_heading = nullptr;    // [steps + 1]
  const double* omega_at = nullptr;       // [steps + 1] rotational velocity reached [rad/s]
  const std::uint8_t* classes = nullptr;  // [(steps + 1) * stride] of the centre's cells, see CellClasses; may be null
  const std::uint8_t* touched = nullptr;  // [count] classes of all poses of a candidate, or-ed; null with `classes`
  std::uint8_t touched_any = 0xFF;        // `touched` of all candidates, or-ed; every class where nobody has looked
  bool ascending = false;                 // no candidate is slower than the one before it
  EndCells* ends = nullptr;               // of this tile, shared by its critics; may be null

  double x_at(std::size_t k, std::size_t c) const { return x[k * stride + c]; }
  double y_at(std::size_t k, std::size_t c) const { return y[k * stride + c]; }
  Pose2 pose(std::size_t k, std::size_t c) const { return {x_at(k, c), y_at(k, c), heading[k]}; }
  Pose2 last_pose(std::size_t c) const { return pose(steps, c); }
  Twist2 sample(std::size_t c) const { return {v[c], omega}; }
};

}  // namespace hidwa_local_planner
