// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/scores.hpp"

#include <algorithm>
#include <limits>

#include "hidwa_local_planner/core/util/vector_clones.hpp"

namespace hidwa_local_planner {
namespace {

HIDWA_VECTOR_CLONES
void add_weighted(double weight, const double* __restrict raw, std::size_t count, double* __restrict total) {
  for (std::size_t c = 0; c < count; ++c) total[c] += weight * raw[c];
}

// Of samples of one omega: `of_turn` is its part of the deviation.
HIDWA_VECTOR_CLONES
void add_deviation(double s_v, double target_v, double of_turn, const double* __restrict v, std::size_t count,
                   double* __restrict total) {
  for (std::size_t c = 0; c < count; ++c) total[c] += s_v * std::abs(target_v - v[c]) + of_turn;
}

}  // namespace

void Scores::resize(std::size_t candidates, std::size_t critics) {
  resize_with_spare(totals_, candidates);
  resize_with_spare(rejected_by_, candidates);
  resize_with_spare(reasons_, candidates);
  raw_.resize(critics);
  for (std::vector<double>& raw : raw_) resize_with_spare(raw, candidates);
}

void Scores::begin(const Tile& tile) {
  std::fill_n(rejected_by_.begin() + static_cast<std::ptrdiff_t>(tile.first), tile.count, kNobody);
  std::fill_n(reasons_.begin() + static_cast<std::ptrdiff_t>(tile.first), tile.count, nullptr);
}

void Scores::score(const CycleView& view, const Tile& tile, const CriticSet& critics, const Cycle& cycle,
                   const Steering& steering) {
  // Direct control takes the legal candidate nearest to the operator command: critics only reject.
  ask_critics(view, tile, critics, cycle.intent.influence != Influence::direct);
  if (steering.active) {
    add_deviation(steering.s_v, steering.target.v, steering.s_omega * std::abs(steering.target.omega - tile.omega),
                  tile.v, tile.count, totals_.data() + tile.first);
  }
  reject_infinite(tile, critics);
}

void Scores::ask_critics(const CycleView& view, const Tile& tile, const CriticSet& critics, bool scores_count) {
  double* total = totals_.data() + tile.first;
  std::fill_n(total, tile.count, 0.0);
  for (std::size_t i = 0; i < critics.size(); ++i) {
    double* own = raw_[i].data() + tile.first;
    TileScores scores(own, reasons_.data() + tile.first, tile.count);
    if (critics[i].weight != 0.0) critics[i].critic->score(view, tile, scores);
    if (!scores.any_set()) {
      std::fill_n(own, tile.count, 0.0);
    } else if (scores_count) {
      add_weighted(critics[i].weight, own, tile.count, total);
    }
    if (!scores.any_rejected()) continue;
    for (std::size_t c = tile.first; c < tile.first + tile.count; ++c) {
      if (reasons_[c] != nullptr && rejected_by_[c] == kNobody) {
        rejected_by_[c] = static_cast<Rejecter>(kFirstCritic + i);
      }
    }
  }
}

void Scores::reject_infinite(const Tile& tile, const CriticSet& critics) {
  double* __restrict total = totals_.data() + tile.first;
  Rejecter* __restrict rejecter = rejected_by_.data() + tile.first;
  unsigned any = 0;
  for (std::size_t c = 0; c < tile.count; ++c) {
    any |= std::abs(total[c]) <= std::numeric_limits<double>::max() ? 0U : 1U;
  }
  for (std::size_t c = 0; any != 0 && c < tile.count; ++c) {
    if (rejecter[c] != kNobody || std::isfinite(total[c])) continue;
    rejecter[c] = maker_of_infinite(tile.first + c, critics);
    reasons_[tile.first + c] = kNotANumber;
  }
  for (std::size_t c = 0; c < tile.count; ++c) {
    total[c] = rejecter[c] == kNobody ? total[c] : std::numeric_limits<double>::infinity();
  }
}

Rejecter Scores::maker_of_infinite(std::size_t candidate, const CriticSet& critics) const {
  for (std::size_t i = 0; i < critics.size(); ++i) {
    if (!std::isfinite(critics[i].weight * raw_[i][candidate])) return static_cast<Rejecter>(kFirstCritic + i);
  }
  return kFirstCritic;
}

void Scores::reject(std::size_t candidate, Rejecter rejecter, const char* reason) {
  totals_[candidate] = std::numeric_limits<double>::infinity();
  rejected_by_[candidate] = rejecter;
  reasons_[candidate] = reason;
}

}  // namespace hidwa_local_planner
