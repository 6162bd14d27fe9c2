// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace hidwa_local_planner::kernel {

/// A critic's scores of a tile, and what they weigh.
struct WeighedScores {
  const double* raw = nullptr;  // [count]
  double weight = 0.0;
};

/// What the person wants, against a tile's samples.
struct Deviation {
  const double* v = nullptr;  // [count] the samples' [m/s]; null where nobody steers
  double wanted_v = 0.0;      // [m/s]
  double s_v = 0.0;
  double of_turn = 0.0;  // the tile's omega weighs so much
};

/// totals[c] = s_nv * (sum of weight * raw[c], critic by critic) + s_v * |wanted_v - v[c]| + of_turn.
void sum_up(const WeighedScores* scores, std::size_t critics, double s_nv, const Deviation& deviation,
            std::size_t count, double* totals);

}  // namespace hidwa_local_planner::kernel
