// SPDX-License-Identifier: BSD-3-Clause
// Gets autonomy going again that prefers standing still to every legal motion. That happens where the robot faces away
// from the plan and the first part of a turn gains nothing; where the plan follows a corner more closely than the robot
// may, so that all progress costs as much in distance from the plan; and where only another heading leads on at all.
//
// 1. A robot that stands in collision takes at once what leads farthest out of it.
// 2. One that has stood, or turned on the spot at a creep, for long enough begins to recover. It goes on until it has
//    come some way from where it stood, or too much time has passed.
// 3. Meanwhile, in this order: it turns on the spot towards the plan; takes the candidate that comes nearest to the
//    local goal; turns to the nearest heading from which a short way straight on is free and leads nearer to the goal.
//    In collision: to a heading from which straight on leads out.
//
// Why it is safe: it takes legal candidates only, and each of them passes the braking check without gaps. It must see
// all of them, so every candidate is checked before (Evaluation::evaluate()).
#pragma once

#include <vector>

#include "core/collision/admissibility.hpp"
#include "core/collision/collision.hpp"
#include "core/collision/escape.hpp"
#include "core/distance/plan_grids.hpp"
#include "core/motion/rollout.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/core/util/condition_timer.hpp"

namespace hidwa_local_planner {

class RecoveryMotion {
 public:
  /// One cycle with all candidates checked and scored. `totals`: of each candidate, infinite where it is rejected.
  struct Scene {
    const Situation& situation;
    const GridView& grid;
    const Rollout& rollout;
    const std::vector<double>& totals;
    const CollisionChecker& collision;
    AdmissibilityCheck& admissibility;
    EscapeRule& escape;
    PlanGrids& grids;
  };

  void reset() { *this = RecoveryMotion(); }
  /// The candidate that leads on; -1 where there is none, or no need of one.
  int choose(const Scene& scene);
  /// How autonomy rested in a cycle, by its choice or since nothing was legal.
  struct Rest {
    bool stands = false;
    bool creeps = false;  // turns on the spot so slowly that it gains nothing
  };
  /// After each cycle. `patience` [s]: for how long the robot may rest before it begins to recover; negative: for ever.
  /// True when it begins.
  bool watch(const Situation& situation, const Rest& rest, double patience);
  /// It recovers.
  bool active() const { return active_; }
  /// For how long autonomy has stood [s].
  double standing_time(double now) const { return stands_.time(now); }
  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.stands_, self.rests_, self.active_, self.stood_, self.begun_, self.facing_plan_, self.turning_to_plan_,
       self.turning_, self.heading_);
  }

 private:
  int towards_plan(const Scene& scene);
  int towards_goal(const Scene& scene) const;
  int towards_free_heading(const Scene& scene);
  int out_of_collision(const Scene& scene) const;
  int turn_by(const Scene& scene, double angle) const;
  bool leads_on(const Scene& scene, double heading) const;
  bool may_face(const Scene& scene, double heading) const;

  ConditionTimer stands_, rests_;  // it stands; it stands or creeps
  bool active_ = false;
  Pose2 stood_;               // where it began
  double begun_ = 0.0;        // [s]
  bool facing_plan_ = false;  // it does, or has since it began
  bool turning_to_plan_ = false;
  bool turning_ = false;  // to a free heading
  double heading_ = 0.0;  // that one, costmap frame [rad]
};

}  // namespace hidwa_local_planner
