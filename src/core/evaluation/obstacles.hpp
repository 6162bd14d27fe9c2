// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/collision/admissibility.hpp"
#include "core/collision/cell_classes.hpp"
#include "core/collision/collision.hpp"
#include "core/collision/escape.hpp"
#include "core/cycle/cycle.hpp"
#include "core/motion/rollout.hpp"

namespace hidwa_local_planner {

/// What the robot may hit, and all that is asked about it: the obstacles within reach (CollisionChecker), what their
/// cells say of a tile's poses (CellClasses), the collision the robot may stand in (EscapeRule), and what is free of
/// collision and can brake (AdmissibilityCheck).
class Obstacles {
 public:
  /// Finds what the robot overlaps, and returns the limits of the dynamic window: in collision all candidates must be
  /// slow, and of the usual window hardly any would be slow enough.
  VelocityLimits find_overlaps(const Cycle& cycle);
  /// Once per evaluation, for the candidates that were rolled out. `turn_out`: see AdmissibilityCheck::Setup.
  void prepare(const Cycle& cycle, const Rollout& rollout, const ComfortTurn& comfort, bool steered, bool turn_out);

  /// The classes of the cells under a tile's candidates. Valid until the next call.
  TileCells cells_under(const Tile& tile) { return classes_.under(collision_, tile); }
  /// The robot overlaps an obstacle.
  bool in_collision() const { return escape_.overlaps(); }
  const CollisionChecker& collision() const { return collision_; }
  AdmissibilityCheck& admissibility() { return admissibility_; }
  EscapeRule& escape() { return escape_; }

 private:
  struct Reach {
    double all = 0.0;        // of the robot's centre in any rollout or brake manoeuvre, with its growth, at most [m]
    double margin = 0.0;     // around a clear position [m]
    double clearance = 0.0;  // the largest that is told [m]
  };
  static Reach reach_of(const Cycle& cycle, const Rollout& rollout);

  EscapeRule escape_;
  CollisionChecker collision_;
  CellClasses classes_;
  AdmissibilityCheck admissibility_;
};

}  // namespace hidwa_local_planner
