// SPDX-License-Identifier: BSD-3-Clause
// Selects the cheapest legal candidate.
//
// 1. The cheapest tile, and in it the cheapest candidate: its exact check comes now (LazyChecks).
// 2. Where it is legal, those of equal total that the tie rule prefers to it are checked too; the winner is confirmed.
// 3. Where it is not, or the winner is not confirmed, all candidates left go onto a heap. They are taken off cheapest
//    first, equals together, until one is legal and confirmed.
//
// Mostly 1 and 2 are enough, and no heap is made. Both give the same answer: the smallest total of all legal
// candidates, of equals whichever the tie rule prefers. lazy_checks.hpp says why unchecked candidates cannot win.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/evaluation/candidates.hpp"
#include "core/evaluation/lazy_checks.hpp"
#include "core/evaluation/scores.hpp"
#include "core/evaluation/tie_rule.hpp"

namespace hidwa_local_planner {

class Selection {
 public:
  Selection(const Candidates& candidates, const Scores& scores, LazyChecks& checks)
      : candidates_(candidates), scores_(scores), checks_(checks) {}

  /// The number of the candidate; -1 where none is legal. Candidates are scored, `checks` has begun with them.
  int cheapest(const TieRule& tie);

 private:
  using Queued = std::pair<double, std::uint32_t>;  // total, candidate

  int cheapest_of_remaining(const TieRule& tie);
  std::uint32_t take_equals(const TieRule& tie);
  void pop();
  void push(const Queued& queued);

  const Candidates& candidates_;
  const Scores& scores_;
  LazyChecks& checks_;
  std::vector<Queued> queue_;          // a heap, cheapest on top
  std::vector<std::uint32_t> equals_;  // legal candidates of equal totals
};

}  // namespace hidwa_local_planner
