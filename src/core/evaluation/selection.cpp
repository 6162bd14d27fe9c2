// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/selection.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {

int Selection::cheapest(const TieRule& tie) {
  const Rollout& rollout = candidates_.rollout();
  resize_with_spare(lowest_, scores_.count() > 0 ? rollout.tile_count() : 0);
  for (std::size_t t = 0; t < lowest_.size(); ++t) lowest_[t] = scores_.total(cheapest_of(rollout.extent(t)));
  for (;;) {
    const auto least = std::min_element(lowest_.begin(), lowest_.end());
    if (least == lowest_.end() || !std::isfinite(*least)) return -1;
    const Tile& tile = rollout.extent(static_cast<std::size_t>(least - lowest_.begin()));
    const std::size_t best = cheapest_of(tile);
    // If the totals differ, the cheapest candidate was rejected in the meantime.
    if (scores_.total(best) == *least && checks_.legal(best)) {
      const std::size_t preferred = preferred_to(best, tie);
      if (checks_.confirm(preferred)) return static_cast<int>(preferred);
    }
    *least = scores_.total(cheapest_of(tile));
  }
}

// Of equals the first.
std::size_t Selection::cheapest_of(const Tile& tile) const {
  const double* totals = scores_.totals().data() + tile.first;
  return tile.first + static_cast<std::size_t>(std::min_element(totals, totals + tile.count) - totals);
}

// The legal candidate of equal total that the tie rule prefers: `best`, which is legal, or another one.
std::size_t Selection::preferred_to(std::size_t best, const TieRule& tie) {
  const double equal = scores_.total(best) + kEqual;
  for (std::size_t t = 0; t < lowest_.size(); ++t) {
    if (lowest_[t] > equal) continue;
    const Tile& tile = candidates_.rollout().extent(t);
    for (std::size_t c = tile.first; c < tile.first + tile.count; ++c) {
      if (scores_.total(c) <= equal && tie.prefers(candidates_.sample(c), candidates_.sample(best)) &&
          checks_.legal(c)) {
        best = c;
      }
    }
  }
  return best;
}

}  // namespace hidwa_local_planner
