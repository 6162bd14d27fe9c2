// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/collision/braking_check.hpp"
#include "core/collision/check_setup.hpp"
#include "core/collision/clearance_lookup.hpp"
#include "core/collision/rollout_check.hpp"
#include "hidwa_local_planner/core/footprint.hpp"
#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/tile.hpp"

namespace hidwa_local_planner {

/// Which candidates are free of collision (RolloutCheck), and which of them can still come to rest in free space
/// (BrakingCheck), before anything that moves can touch it (MoverCheck). The first two share the known clearances. For
/// a robot that already stands in collision EscapeRule holds, too. Where no motion leads out, the robot may turn on the
/// spot if it goes no deeper. An operator may always turn it so, or have it stand.
class AdmissibilityCheck {
 public:
  using Setup = CheckSetup;

  AdmissibilityCheck() = default;
  AdmissibilityCheck(const AdmissibilityCheck&) = delete;
  AdmissibilityCheck& operator=(const AdmissibilityCheck&) = delete;

  /// Once per evaluation; `checker` is prepared (EscapeRule::rest() where that applies). All but `setup` itself must
  /// outlive the questions. `resolution` is the map's [m].
  void prepare(const Parameters& parameters, const CollisionChecker& checker, const Footprint& footprint,
               double resolution, const Setup& setup) {
    setup_ = setup;
    checks_braking_ = parameters.admissibility == Admissibility::braking;
    const double radius = footprint.circumscribed_radius();
    clearances_.prepare(checker, radius, resolution);
    rollouts_.prepare(setup_, clearances_, radius, resolution);
    braking_.prepare(parameters, setup_, clearances_, radius, resolution);
  }

  /// Whether the cells alone decide every rollout of a tile. Sets the reasons of those that they reject.
  bool cells_decide(const Tile& tile, const char** reasons) const { return rollouts_.decide_by_cells(tile, reasons); }
  /// Sets the reasons of those candidates of a tile whose rollouts are not free.
  void check_rollouts(const Tile& tile, const char** reasons) { rollouts_.check(tile, reasons); }

  /// Candidates must be able to brake.
  bool checks_braking() const { return checks_braking_; }
  /// Every candidate can brake: can_brake() need not be called.
  bool all_can_brake() const { return braking_.all_can_brake(); }
  /// Nothing that moves is near, and nobody may come out: can_rest() and rests_before_hidden() need not be called.
  bool all_can_rest() const { return setup_.movers == nullptr && setup_.hidden == nullptr; }
  /// Whether the robot can come to rest in free space after the first command towards a sample, however the base
  /// reaches its commands: poses at most half a cell apart.
  bool can_brake(const Twist2& sample) { return braking_.can_brake(sample); }
  /// Whether the robot can come to rest, likewise, before anything that moves can touch it.
  bool can_rest(const Twist2& sample) {
    return setup_.movers == nullptr || setup_.movers->can_rest(braking_.command_for(sample));
  }
  /// Likewise, somebody who may come out of where nobody sees him.
  bool rests_before_hidden(const Twist2& sample) {
    return setup_.hidden == nullptr || setup_.hidden->can_rest(braking_.command_for(sample));
  }
  /// As can_brake(), without gaps between the poses: for the candidate that is chosen.
  bool confirm_braking(const Twist2& sample) { return braking_.confirm_braking(sample); }
  /// Likewise can_rest().
  bool confirm_rest(const Twist2& sample) {
    return setup_.movers == nullptr || setup_.movers->confirm(braking_.command_for(sample));
  }
  /// Likewise rests_before_hidden().
  bool confirm_hidden(const Twist2& sample) {
    return setup_.hidden == nullptr || setup_.hidden->confirm(braking_.command_for(sample));
  }
  /// The first command towards a sample [m/s, rad/s].
  Twist2 command_for(const Twist2& sample) const { return braking_.command_for(sample); }

 private:
  Setup setup_;
  bool checks_braking_ = true;
  ClearanceLookup clearances_;
  RolloutCheck rollouts_;
  BrakingCheck braking_;
};

}  // namespace hidwa_local_planner
