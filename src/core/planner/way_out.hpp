// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/collision/admissibility.hpp"
#include "core/collision/collision.hpp"
#include "core/distance/plan_grids.hpp"
#include "core/motion/rollout.hpp"
#include "hidwa_local_planner/core/grid_view.hpp"
#include "hidwa_local_planner/core/planner.hpp"
#include "hidwa_local_planner/core/util/lasting.hpp"

namespace hidwa_local_planner {

/// Gets autonomy going again that prefers standing still to every legal move. That happens where it faces away from
/// the plan and the first part of a turn gains nothing; where the plan hugs a corner more closely than the robot may,
/// so that all progress costs as much in distance from the plan; and where only another heading leads on at all.
///
/// Then, in this order: turn towards the plan on the spot; take the legal candidate that comes nearest to the local
/// goal; turn to the nearest heading from which a short way straight on is free and leads nearer to it. Once begun that
/// goes on until the robot has come some way from where it stood. A robot that stands in collision takes at once what
/// leads farthest out of it; where nothing does, it turns to where that is straight on. Only legal candidates are
/// taken.
class WayOut {
 public:
  /// One cycle, as it was weighed. `totals`: of each candidate, infinite where it was refused.
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

  void reset() { *this = WayOut(); }
  /// The candidate that leads out; -1 where there is none, or nothing to lead out of.
  int choose(const Scene& scene);
  /// What a cycle of autonomy came to, of its own choice or since nothing was legal.
  struct Rest {
    bool stands = false;
    bool creeps = false;  // turns on the spot so slowly that it gains nothing
  };
  /// `patience` [s]: for how long it may rest before it looks for a way out; negative: for ever. True when it begins
  /// to look.
  bool watch(const Situation& situation, const Rest& rest, double patience);
  /// It is looking for one.
  bool active() const { return active_; }
  /// It has stood for so long [s].
  double rest(double now) const { return stands_.time(now); }
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

  Lasting stands_, rests_;  // it stands; it stands or creeps
  bool active_ = false;
  Pose2 stood_;               // where it began
  double begun_ = 0.0;        // [s]
  bool facing_plan_ = false;  // it does, or has since it began
  bool turning_to_plan_ = false;
  bool turning_ = false;  // to a free heading
  double heading_ = 0.0;  // that one, costmap frame [rad]
};

}  // namespace hidwa_local_planner
