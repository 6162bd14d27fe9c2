// SPDX-License-Identifier: BSD-3-Clause
// Looks for the candidates' collisions, as late as the choice allows: the cheapest candidates are looked at, the others
// only where all of them are asked for.
#include <algorithm>
#include <limits>

#include "core/planner/planner_impl.hpp"

namespace hidwa_local_planner {

void Planner::Impl::list_checks() {
  fit(checks, rollout.tile_count());
  double omega = 0.0;
  std::size_t first = 0;  // candidate of that omega
  std::size_t most = 0;   // candidates of a tile
  for (std::size_t t = 0; t < checks.size(); ++t) {
    const Tile tile = rollout.extent(t);
    if (t == 0 || tile.omega != omega) {
      omega = tile.omega;
      first = tile.first;
    }
    checks[t].column = tile.first - first;
    checks[t].done = false;
    most = std::max(most, tile.count);
  }
  fit(found, most);
}

// What the cells around the robot tell of a tile: often all.
void Planner::Impl::check_cells(const Tile& tile, TileCheck& check) {
  const char** reason = reasons.data() + tile.first;
  const bool decided = admissibility.cells_decide(tile, reason);
  const bool hits = (tile.touched_any & cell_class::kHit) != 0;
  for (std::size_t c = 0; hits && c < tile.count; ++c) {
    if (reason[c] != nullptr) refused_by[tile.first + c] = kCollision;
  }
  check.done = decided && (parameters.admissibility != Admissibility::braking || admissibility.all_can_brake());
}

void Planner::Impl::check_closely(const Tile& tile, TileCheck& check) {
  if (check.done) return;
  check.done = true;
  std::fill_n(found.begin(), tile.count, nullptr);
  admissibility.check_rollouts(tile, found.data());
  const bool braking = parameters.admissibility == Admissibility::braking;
  for (std::size_t c = 0; c < tile.count; ++c) {
    if (found[c] != nullptr) {
      refuse(tile.first + c, kCollision, found[c]);
    } else if (braking && !admissibility.can_brake(tile.sample(c), check.column + c)) {
      refuse(tile.first + c, kBraking, kCannotBrake);
    }
  }
}

// A whole tile: the next candidates that are asked for mostly belong to it, and share what is found.
void Planner::Impl::check_tile(std::size_t t) {
  if (checks[t].done) return;
  Tile tile = rollout.tile(t);
  classes.classify(tile);
  check_closely(tile, checks[t]);
}

void Planner::Impl::check_all_tiles() {
  for (std::size_t t = 0; t < checks.size(); ++t) check_tile(t);
}

bool Planner::Impl::stays_legal(std::size_t candidate) {
  check_tile(rollout.tile_of(candidate));
  return std::isfinite(totals[candidate]);
}

// Whoever refused it before: collision and braking come first.
void Planner::Impl::refuse(std::size_t candidate, std::uint8_t refuser, const char* reason) {
  totals[candidate] = std::numeric_limits<double>::infinity();
  refused_by[candidate] = refuser;
  reasons[candidate] = reason;
}

}  // namespace hidwa_local_planner
