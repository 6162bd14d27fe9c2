// SPDX-License-Identifier: BSD-3-Clause
// From the start of a cycle to scored candidates:
//
// 1. what the robot overlaps decides the limits of the dynamic window (Obstacles);
// 2. candidates are sampled and rolled out (Candidates);
// 3. obstacles and distances are prepared as far as the candidates reach (Obstacles, PlanGrids);
// 4. each tile is checked as far as its cells decide (LazyChecks) and scored (Scores).
//
// If the plan is off the map and nobody steers, critics have nothing to score by: nothing is scored.
#pragma once

#include "core/distance/plan_grids.hpp"
#include "core/evaluation/candidates.hpp"
#include "core/evaluation/critic_set.hpp"
#include "core/evaluation/lazy_checks.hpp"
#include "core/evaluation/obstacles.hpp"
#include "core/evaluation/scores.hpp"
#include "core/evaluation/tile_surroundings.hpp"

namespace hidwa_local_planner {

/// What the parts that choose and explain may look at.
class Evaluation {
 public:
  explicit Evaluation(const CriticSet& critics) : critics_(critics) {}

  /// What one evaluation was made with.
  struct Result {
    CycleView view;       // what the critics saw; lives as long as the cycle
    bool scored = false;  // false where there was nothing to score by
    bool gentle = false;  // `comfort` bound the candidates
  };
  struct Mode {
    double sim_time = 0.0;    // how far ahead candidates are rolled out [s]
    bool recovering = false;  // see Recovery::active()
    ComfortTurn comfort;      // does not bind in collision
    bool to_goal = false;     // see Recovery::leads_to_goal()
  };
  /// Up to three times per cycle. With an operator once, and once before where the operator command is blended. For
  /// autonomy once, once more where it gives up turning gently, and once more where evasion needs other turns.
  Result evaluate(const Cycle& cycle, const Steering& steering, const Mode& mode);
  /// Nothing is evaluated.
  void clear() { scores_.clear(); }

  const Candidates& candidates() const { return candidates_; }
  const Scores& scores() const { return scores_; }
  LazyChecks& checks() { return checks_; }
  Obstacles& obstacles() { return obstacles_; }

 private:
  CycleView view_of(const Cycle& cycle, const Steering& steering, bool to_goal);
  void prepare_grids(const Cycle& cycle);
  void score_tiles(const Cycle& cycle, const Steering& steering, const CycleView& view, bool check_closely);

  const CriticSet& critics_;
  Candidates candidates_;
  Obstacles obstacles_;
  PlanGrids grids_;
  TileSurroundings surroundings_;
  Scores scores_;
  LazyChecks checks_{candidates_, obstacles_, surroundings_, scores_};
};

}  // namespace hidwa_local_planner
