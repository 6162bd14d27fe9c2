// SPDX-License-Identifier: BSD-3-Clause
#include "core/search/move_set.hpp"

#include <algorithm>
#include <cmath>

namespace hidwa_local_planner {
namespace {

// Arcs turn by so many turns of their fineness.
constexpr int kArcTurns[] = {0, 1, -1, 2, -2};

Move driving(const SearchTask& task, MoveKind kind, double length, int turn, double radius) {
  Move move;
  move.kind = kind;
  move.turn = turn;
  move.length = kind == MoveKind::forward ? length : -length;
  const double angle = std::abs(turn) * kHeadingStep;
  const double speed = kind == MoveKind::forward ? task.forward : task.backward;
  move.time = std::max(length / speed, task.turning > 0.0 ? angle / task.turning : 0.0);
  move.reach = length + angle * radius;
  const Pose2 end = part_of(move, 1.0);
  move.x = end.x;
  move.y = end.y;
  return move;
}

Move turning(const SearchTask& task, int turn, double radius) {
  Move move;
  move.kind = MoveKind::turn;
  move.turn = turn;
  move.time = std::abs(turn) * kHeadingStep / task.turning;
  move.reach = std::abs(turn) * kHeadingStep * radius;
  return move;
}

void fill(const SearchTask& task, double length, int turn, double radius, MoveSet& set) {
  set.moves.clear();
  const bool turns = task.turning > 0.0;
  for (const MoveKind kind : {MoveKind::forward, MoveKind::backward}) {
    if ((kind == MoveKind::forward ? task.forward : task.backward) <= 0.0) continue;
    for (const int turns_by : kArcTurns) {
      if (turns_by == 0 || turns) set.moves.push_back(driving(task, kind, length, turns_by * turn, radius));
    }
  }
  if (!turns) return;
  set.moves.push_back(turning(task, turn, radius));
  set.moves.push_back(turning(task, -turn, radius));
}

}  // namespace

Pose2 part_of(const Move& move, double share) {
  const double angle = move.turn * kHeadingStep * share, length = move.length * share;
  if (std::abs(angle) < 1e-9) return {length, 0.0, angle};
  const double radius = length / angle;
  return {radius * std::sin(angle), radius * (1.0 - std::cos(angle)), angle};
}

void MoveSets::make(const SearchTask& task, double radius, Pass pass) {
  const bool coarse = pass == Pass::coarse;
  const double cell = std::min(task.map.resolution, kUsualCell);
  MoveSet& open = sets_[static_cast<std::size_t>(Fineness::open)];
  MoveSet& tight = sets_[static_cast<std::size_t>(Fineness::tight)];
  MoveSet& touching = sets_[static_cast<std::size_t>(Fineness::touching)];
  open.bin = 2.0 * kUsualCell;
  open.heading_bin = 12;
  fill(task, 3.0 * kUsualCell, open.heading_bin, radius, open);
  tight.bin = (coarse ? 1.0 : 0.5) * cell;
  tight.heading_bin = coarse ? 6 : 4;
  fill(task, (coarse ? 1.5 : 1.0) * cell, tight.heading_bin, radius, tight);
  touching.bin = 0.125 * cell;
  touching.heading_bin = 1;
  fill(task, 0.25 * cell, touching.heading_bin, radius, touching);
}

}  // namespace hidwa_local_planner
