// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace hidwa_local_planner::kernel {

/// Numbers a row of a tile is padded to: whole registers, no remainder loop.
constexpr std::size_t kLaneMultiple = 4;

/// Positions of a tile, step by step. A candidate's speed is its sample `v` as far as the ramp allows, `slowest` and
/// `fastest`, and a step goes on at the mean of two speeds, or with `euler` at the one reached.
struct RollRequest {
  std::size_t steps = 0;
  std::size_t ramp_steps = 0;  // from here on every candidate has its own speed
  std::size_t stride = 0;      // a multiple of kLaneMultiple
  bool euler = false;
  const double* v = nullptr;        // [stride] [m/s]
  const double* slowest = nullptr;  // [ramp_steps + 1] [m/s]
  const double* fastest = nullptr;  // [ramp_steps + 1] [m/s]
  const double* step_x = nullptr;   // [steps] metres along x a step at 1 m/s
  const double* step_y = nullptr;   // [steps]
};

/// Fills rows 1 to `steps` of x and y from row 0. All rows are `stride` long.
void roll(const RollRequest& request, double* x, double* y);

}  // namespace hidwa_local_planner::kernel
