// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/selection.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace hidwa_local_planner {

int Selection::cheapest(const TieRule& tie) {
  reserve_with_spare(queue_, scores_.count());  // for the cycles that need it
  reserve_with_spare(equals_, scores_.count());
  const std::vector<double>& lowest = scores_.lowest();
  const std::vector<double>& totals = scores_.totals();
  const Rollout& rollout = candidates_.rollout();
  const auto least = std::min_element(lowest.begin(), lowest.end());
  if (least == lowest.end() || !std::isfinite(*least)) return -1;
  const Tile cheapest = rollout.extent(static_cast<std::size_t>(least - lowest.begin()));
  std::size_t best = cheapest.first;
  while (best + 1 < cheapest.first + cheapest.count && totals[best] != *least) ++best;
  const double equal = *least + kEqual;
  // If the totals differ, the cheapest candidate was rejected after its tile was scored.
  if (totals[best] != *least || !checks_.legal(best)) return cheapest_of_remaining(tie);
  for (std::size_t t = 0; t < lowest.size(); ++t) {
    if (lowest[t] > equal) continue;
    const Tile tile = rollout.extent(t);
    for (std::size_t c = tile.first; c < tile.first + tile.count; ++c) {
      if (totals[c] <= equal && tie.prefers(candidates_.sample(c), candidates_.sample(best)) && checks_.legal(c)) {
        best = c;
      }
    }
  }
  return checks_.confirm(best) ? static_cast<int>(best) : cheapest_of_remaining(tie);
}

int Selection::cheapest_of_remaining(const TieRule& tie) {
  queue_.clear();
  for (std::size_t c = 0; c < scores_.count(); ++c) {
    if (scores_.legal(c)) queue_.emplace_back(scores_.total(c), static_cast<std::uint32_t>(c));
  }
  std::make_heap(queue_.begin(), queue_.end(), std::greater<Queued>());
  while (!queue_.empty()) {
    if (!checks_.legal(queue_.front().second)) {
      pop();
      continue;
    }
    const std::uint32_t best = take_equals(tie);
    if (checks_.confirm(best)) return static_cast<int>(best);
    for (const std::uint32_t c : equals_) {
      if (c != best) push({scores_.total(c), c});
    }
  }
  return -1;
}

// Takes the cheapest candidate, which is legal, and its equals off the heap. Returns the one that the tie rule prefers.
std::uint32_t Selection::take_equals(const TieRule& tie) {
  std::uint32_t best = queue_.front().second;
  const double equal = queue_.front().first + kEqual;
  equals_.clear();
  while (!queue_.empty() && queue_.front().first <= equal) {
    if (checks_.legal(queue_.front().second)) equals_.push_back(queue_.front().second);
    pop();
  }
  std::sort(equals_.begin(), equals_.end());
  for (const std::uint32_t c : equals_) {
    if (tie.prefers(candidates_.sample(c), candidates_.sample(best))) best = c;
  }
  return best;
}

void Selection::pop() {
  std::pop_heap(queue_.begin(), queue_.end(), std::greater<Queued>());
  queue_.pop_back();
}

void Selection::push(const Queued& queued) {
  queue_.push_back(queued);
  std::push_heap(queue_.begin(), queue_.end(), std::greater<Queued>());
}

}  // namespace hidwa_local_planner
