// SPDX-License-Identifier: BSD-3-Clause
#include "core/evaluation/lazy_checks.hpp"

#include <algorithm>

namespace hidwa_local_planner {

void LazyChecks::begin(const BlindMotion& blind) {
  blind_ = &blind;
  const Rollout& rollout = candidates_.rollout();
  resize_with_spare(states_, rollout.tile_count());
  const bool rests = !admissibility_.checks_braking() || admissibility_.all_can_rest();
  std::size_t largest = 0;  // tile
  for (std::size_t t = 0; t < states_.size(); ++t) {
    states_[t] = {false, rests};
    largest = std::max(largest, rollout.extent(t).count);
  }
  resize_with_spare(found_, largest);
}

Tile LazyChecks::tile(std::size_t index) {
  Tile tile = candidates_.rollout().tile(index);
  tile.cells = obstacles_.cells_under(tile);
  tile.surroundings = &surroundings_;
  return tile;
}

void LazyChecks::check_before_scoring(const Tile& tile, std::size_t index, bool closely) {
  TileState& state = states_[index];
  check_cells(tile, state);
  if (!closely) return;
  check_closely(tile, state);
  check_rests(tile, state);
}

void LazyChecks::check_cells(const Tile& tile, TileState& state) {
  const char** reason = scores_.reasons().data() + tile.first;
  const bool decided = admissibility_.cells_decide(tile, reason);
  const bool hits = (tile.cells.touched_any & cell_class::kHit) != 0;
  for (std::size_t c = 0; hits && c < tile.count; ++c) {
    if (reason[c] != nullptr) scores_.rejected_by()[tile.first + c] = kCollision;
  }
  if (blind_->bounds()) check_sight(tile);
  state.done = decided && (!admissibility_.checks_braking() || admissibility_.all_can_brake());
}

// Candidates of a tile have one rate of turn.
void LazyChecks::check_sight(const Tile& tile) {
  const Interval allowed = blind_->speeds(tile.omega);
  for (std::size_t c = 0; c < tile.count; ++c) {
    const bool seen = tile.v[c] >= allowed.lo && tile.v[c] <= allowed.hi;
    if (!seen && scores_.rejected_by()[tile.first + c] == kNobody) scores_.reject(tile.first + c, kBlind, kUnseen);
  }
}

void LazyChecks::check_closely(const Tile& tile, TileState& state) {
  if (state.done) return;
  state.done = true;
  const bool braking = admissibility_.checks_braking();
  std::fill_n(found_.begin(), tile.count, nullptr);
  admissibility_.check_rollouts(tile, found_.data());
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (found_[c] != nullptr) {
      scores_.reject(tile.first + c, kCollision, found_[c]);
    } else if (braking && !admissibility_.can_brake(tile.sample(c))) {
      scores_.reject(tile.first + c, kBraking, kCannotBrake);
    }
  }
}

// Once all else is checked.
void LazyChecks::check_rests(const Tile& tile, TileState& state) {
  if (state.rests) return;
  state.rests = true;
  for (std::size_t c = 0; c < tile.count; ++c) check_rest(tile.first + c);
}

// Candidates that a critic rejected are checked, too.
void LazyChecks::check_rest(std::size_t candidate) {
  const Rejecter by = scores_.rejected_by()[candidate];
  if (by != kNobody && by < kFirstCritic) return;
  const Twist2& sample = candidates_.sample(candidate);
  if (!admissibility_.can_rest(sample)) {
    scores_.reject(candidate, kMovingObstacle, kMayBeTouched);
  } else if (!admissibility_.rests_before_hidden(sample)) {
    scores_.reject(candidate, kOcclusion, kHidden);
  }
}

void LazyChecks::check_tile(std::size_t index) {
  if (!states_[index].done) check_closely(tile(index), states_[index]);
}

bool LazyChecks::legal(std::size_t candidate) {
  const std::size_t tile = candidates_.rollout().tile_of(candidate);
  check_tile(tile);
  if (!states_[tile].rests) check_rest(candidate);
  return scores_.legal(candidate);
}

bool LazyChecks::confirm(std::size_t candidate) {
  const Twist2& sample = candidates_.sample(candidate);
  const auto reject = [&](Rejecter rejecter, const char* reason) {
    scores_.reject(candidate, rejecter, reason);
    return false;
  };
  if (!slow_where_blind(sample)) return reject(kBlind, kUnseen);
  if (!admissibility_.checks_braking()) return true;
  if (!admissibility_.confirm_braking(sample)) return reject(kBraking, kCannotBrake);
  if (!admissibility_.confirm_rest(sample)) return reject(kMovingObstacle, kMayBeTouched);
  return admissibility_.confirm_hidden(sample) || reject(kOcclusion, kHidden);
}

bool LazyChecks::slow_where_blind(const Twist2& sample) const {
  return blind_->allows(sample) && blind_->allows_braking_from(admissibility_.command_for(sample));
}

void LazyChecks::check_all() {
  for (std::size_t t = 0; t < states_.size(); ++t) {
    check_tile(t);
    check_rests(candidates_.rollout().extent(t), states_[t]);
  }
}

bool LazyChecks::any_motion_legal() {
  for (std::size_t c = 0; c < scores_.count(); ++c) {
    if (!(candidates_.sample(c) == Twist2{}) && legal(c)) return true;
  }
  return false;
}

}  // namespace hidwa_local_planner
