// SPDX-License-Identifier: BSD-3-Clause
// Checks candidates for collision and braking as late as the choice allows.
//
// 1. Before a tile is scored, the classes of its cells are looked at (check_cells()). They often decide the whole tile,
//    at next to no cost. Where nobody sees, the speed alone decides.
// 2. All candidates are scored, also those that are not checked exactly yet.
// 3. When the choice wants a candidate, its tile is checked exactly (legal()): the outline along the rollouts, and the
//    brake manoeuvres. A whole tile at once, since the next candidate mostly belongs to it and shares what was
//    found.
// 4. The one candidate that is chosen at last passes the braking check, and the check for what moves, without gaps
//    between the poses (confirm()).
//
// Why the choice is the same as if all candidates were checked first: a check can only reject, and a rejection only
// raises the candidate's own total, to infinity; no other total depends on it. So the total of an unchecked candidate
// is a lower bound of its true one. The choice takes candidates in the order of these bounds and takes one only after
// its check, when its bound is its true total. Every candidate left has a bound that is not smaller, and of those that
// are equal each one that the tie rule would prefer is checked before the choice is made. Critics see whether a
// candidate is rejected already, and may save the work of scoring it: that changes no score of another candidate.
// test/oracle/check_all_test.cpp compares both ways.
#pragma once

#include <cstddef>
#include <vector>

#include "core/collision/blind_motion.hpp"
#include "core/evaluation/candidates.hpp"
#include "core/evaluation/obstacles.hpp"
#include "core/evaluation/scores.hpp"
#include "core/evaluation/tile_surroundings.hpp"

namespace hidwa_local_planner {

class LazyChecks {
 public:
  LazyChecks(const Candidates& candidates, Obstacles& obstacles, TileSurroundings& surroundings, Scores& scores)
      : candidates_(candidates),
        obstacles_(obstacles),
        admissibility_(obstacles.admissibility()),
        surroundings_(surroundings),
        scores_(scores) {}

  /// New candidates: nothing is checked.
  void begin(const BlindMotion& blind);
  /// A tile with all that checks and critics read of it. Valid until the next call.
  Tile tile(std::size_t index);
  /// Rejects what the cells around the robot already decide, before the tile is scored. With `closely` checks all.
  void check_before_scoring(const Tile& tile, std::size_t index, bool closely);

  /// Whether a scored candidate is legal; checks it and its tile if need be.
  bool legal(std::size_t candidate);
  /// The last check of the candidate that is to be chosen: is it slow enough where nobody sees, also while it brakes;
  /// can it brake, and rest before anything that moves can touch it, checked without gaps between the poses?
  bool confirm(std::size_t candidate);
  /// Whether a sample, the first command towards it and the braking after that are slow enough where nobody sees.
  bool slow_where_blind(const Twist2& sample) const;
  /// Checks every candidate: afterwards the rejections are complete.
  void check_all();
  /// Whether any legal candidate moves the robot. Where none does, all are checked.
  bool any_motion_legal();

 private:
  // What is known of a tile.
  struct TileState {
    bool done = false;   // no rollout or braking is left to check
    bool rests = false;  // nothing that moves is left to check
  };
  void check_cells(const Tile& tile, TileState& state);
  void check_sight(const Tile& tile);
  void check_closely(const Tile& tile, TileState& state);
  void check_rests(const Tile& tile, TileState& state);
  void check_rest(std::size_t candidate);
  void check_tile(std::size_t index);

  const Candidates& candidates_;
  Obstacles& obstacles_;
  AdmissibilityCheck& admissibility_;  // theirs
  TileSurroundings& surroundings_;
  Scores& scores_;
  const BlindMotion* blind_ = nullptr;
  std::vector<TileState> states_;   // [tiles]
  std::vector<const char*> found_;  // [candidates of a tile] while it is checked
};

}  // namespace hidwa_local_planner
