// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hidwa_local_planner/core/surroundings.hpp"
#include "hidwa_local_planner/core/types.hpp"

namespace hidwa_local_planner {

/// What a cell means to a robot whose centre is in it.
namespace cell_class {
constexpr std::uint8_t kNear = 1;     // it may overlap an obstacle: its outline decides
constexpr std::uint8_t kHit = 2;      // it overlaps one at any heading
constexpr std::uint8_t kBlocked = 4;  // lethal, inscribed, unknown where that is an obstacle, or off the map
}  // namespace cell_class

/// The classes of the cells under a tile's candidates, see cell_class.
struct TileCells {
  const std::uint8_t* classes = nullptr;  // [(steps + 1) * stride] of the cells under the centre
  const std::uint8_t* touched = nullptr;  // [count] classes of all poses of a candidate, or-ed; kHit not of the start
  std::uint8_t touched_any = 0xFF;        // `touched` of all candidates, or-ed; every class where nobody has looked
};

/// Candidates that share the rotational sample and the number of steps, and so every heading: one tile, small enough to
/// stay in the first cache while all critics score it. Positions are rows a step, columns a candidate; row k = 0 is the
/// start pose. Rows are `stride` apart: what lies beyond `count` is padding. A critic gets tiles in which everything is
/// set.
struct Tile {
  double omega = 0.0;                   // the rotational sample [rad/s]
  double dt = 0.0;                      // length of a step [s]
  std::size_t steps = 0;                // poses are steps + 1
  std::size_t first = 0;                // index of the first candidate in the batch's order
  std::size_t count = 0;                // number of candidates
  std::size_t stride = 0;               // >= count
  const double* v = nullptr;            // [count] the forward samples [m/s]
  const double* x = nullptr;            // [(steps + 1) * stride] costmap frame [m]
  const double* y = nullptr;            // [(steps + 1) * stride] costmap frame [m]
  const double* heading = nullptr;      // [steps + 1] [rad]
  const double* cos_heading = nullptr;  // [steps + 1]
  const double* sin_heading = nullptr;  // [steps + 1]
  const double* omega_at = nullptr;     // [steps + 1] rotational velocity reached [rad/s]
  TileCells cells;
  Surroundings* surroundings = nullptr;

  double x_at(std::size_t k, std::size_t c) const { return x[k * stride + c]; }
  double y_at(std::size_t k, std::size_t c) const { return y[k * stride + c]; }
  Pose2 pose(std::size_t k, std::size_t c) const { return {x_at(k, c), y_at(k, c), heading[k]}; }
  Pose2 last_pose(std::size_t c) const { return pose(steps, c); }
  Twist2 sample(std::size_t c) const { return {v[c], omega}; }
  /// The robot's centre enters a cell that is lethal, inscribed, off the map, or unknown where unknown is an obstacle.
  bool centre_blocked(std::size_t c) const { return (cells.touched[c] & cell_class::kBlocked) != 0; }

  /// See Surroundings; `found` [count].
  bool distances(const PlanDistance& distance, double forward, const TileScores& scores, double* found) const {
    return surroundings->distances(*this, distance, forward, scores, found);
  }
  void costs(std::size_t step, double* found) const { surroundings->costs(*this, step, found); }
  void clearances(std::size_t step, double* found) const { surroundings->clearances(*this, step, found); }
};

}  // namespace hidwa_local_planner
