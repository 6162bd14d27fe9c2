// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "core/evaluation/evaluation.hpp"

namespace hidwa_local_planner {

/// The legal candidate with the least `measure(tile, c)`, of equals the cheapest; -1 where there is none. It has passed
/// the last check (LazyChecks::confirm()), and what does not pass it is rejected from then on. Infinite measures are
/// left out. All candidates must have been checked.
template <typename Measure>
int least_legal(Evaluation& evaluated, Measure&& measure) {
  const Rollout& rollout = evaluated.candidates().rollout();
  const std::vector<double>& totals = evaluated.scores().totals();
  double least = std::numeric_limits<double>::infinity(), cost = least;
  int best = -1;
  for (std::size_t t = 0; t < rollout.tile_count(); ++t) {
    const Tile tile = rollout.tile(t);
    for (std::size_t c = 0; c < tile.count; ++c) {
      const double total = totals[tile.first + c];
      if (!std::isfinite(total)) continue;
      const double value = measure(tile, c);
      if (!std::isfinite(value) || value > least || (value == least && total >= cost)) continue;
      if (!evaluated.checks().confirm(tile.first + c)) continue;
      least = value;
      cost = total;
      best = static_cast<int>(tile.first + c);
    }
  }
  return best;
}

}  // namespace hidwa_local_planner
