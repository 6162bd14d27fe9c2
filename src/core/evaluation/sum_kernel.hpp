// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace hidwa_local_planner::kernel {

/// A critic's raw scores of a tile, and its weight.
struct WeightedScores {
  const double* raw = nullptr;  // [count]
  double weight = 0.0;
};

/// What the deviation of a tile's samples is measured against.
struct Deviation {
  const double* v = nullptr;  // [count] the samples' [m/s]; null where the deviation does not count
  double target_v = 0.0;      // [m/s]
  double s_v = 0.0;
  double of_turn = 0.0;  // the part of the tile's omega
};

/// totals[c] = sum of weight * raw[c], critic by critic, + s_v * |target_v - v[c]| + of_turn.
void sum_up(const WeightedScores* scores, std::size_t critics, const Deviation& deviation, std::size_t count,
            double* totals);

}  // namespace hidwa_local_planner::kernel
