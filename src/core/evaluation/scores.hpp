// SPDX-License-Identifier: BSD-3-Clause
// What each candidate costs, and who rejected it.
//
// For one tile (score()):
// 1. every critic gives raw scores or rejects (ask_critics());
// 2. the total is J = the sum of weight * raw, + the deviation from the operator command, in the order of the
//    critics: Kalliokoski 2022, section III;
// 3. a total that is no finite number is a rejection by the critic that made it so: critics of other packages may
//    answer anything;
// 4. the total of a rejected candidate is infinite, so that no search for the cheapest finds it.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/cycle/cycle.hpp"
#include "core/evaluation/critic_set.hpp"
#include "core/evaluation/rejection.hpp"

namespace hidwa_local_planner {

class Scores {
 public:
  /// Makes room; what is in it is set tile by tile, first by begin(), then by score().
  void resize(std::size_t candidates, std::size_t critics);
  /// Nothing was scored.
  void clear() { totals_.clear(); }

  /// Nobody has rejected any candidate of the tile.
  void begin(const Tile& tile);
  /// Scores a tile. Who was rejected before stays so.
  void score(const CycleView& view, const Tile& tile, const CriticSet& critics, const Cycle& cycle,
             const Steering& steering);
  /// Collision and braking reject, whoever did so before: they come first.
  void reject(std::size_t candidate, Rejecter rejecter, const char* reason);

  std::size_t count() const { return totals_.size(); }
  bool legal(std::size_t candidate) const { return std::isfinite(totals_[candidate]); }
  /// J; infinite where it is rejected.
  double total(std::size_t candidate) const { return totals_[candidate]; }
  const std::vector<double>& totals() const { return totals_; }
  double raw(std::size_t critic, std::size_t candidate) const { return raw_[critic][candidate]; }

  /// [candidates] by whom, and why: null where by nobody.
  std::vector<Rejecter>& rejected_by() { return rejected_by_; }
  const std::vector<Rejecter>& rejected_by() const { return rejected_by_; }
  std::vector<const char*>& reasons() { return reasons_; }
  const std::vector<const char*>& reasons() const { return reasons_; }

 private:
  void ask_critics(const CycleView& view, const Tile& tile, const CriticSet& critics, bool scores_count);
  void reject_infinite(const Tile& tile, const CriticSet& critics);
  Rejecter maker_of_infinite(std::size_t candidate, const CriticSet& critics) const;

  std::vector<double> totals_;            // [candidates]
  std::vector<Rejecter> rejected_by_;     // [candidates]
  std::vector<const char*> reasons_;      // [candidates]
  std::vector<std::vector<double>> raw_;  // [critics][candidates]
};

}  // namespace hidwa_local_planner
