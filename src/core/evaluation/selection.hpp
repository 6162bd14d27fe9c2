// SPDX-License-Identifier: BSD-3-Clause
// Selects the cheapest legal candidate.
//
// 1. The cheapest tile, and in it the cheapest candidate: its exact check comes now (LazyChecks).
// 2. Where it is legal, those of equal total that the tie rule prefers to it are checked too; the winner is confirmed.
// 3. Where it is not, or the winner is not confirmed, the search begins again without what was rejected.
//
// The answer is the smallest total of all legal candidates, of equals whichever the tie rule prefers. lazy_checks.hpp
// says why unchecked candidates cannot win.
#pragma once

#include <cstddef>
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
  std::size_t cheapest_of(const Tile& tile) const;
  std::size_t preferred_to(std::size_t best, const TieRule& tie);

  const Candidates& candidates_;
  const Scores& scores_;
  LazyChecks& checks_;
  std::vector<double> lowest_;  // [tiles] no candidate of the tile costs less
};

}  // namespace hidwa_local_planner
