// SPDX-License-Identifier: BSD-3-Clause
// Whether a rollout is free of collision.
//
// 1. The classes of the cells that the robot's centre passes often decide: a cell where the outline hits something at
//    any heading, or only cells where it hits nothing at any heading (decide_by_cells()).
// 2. Otherwise the outline is looked at from pose to pose. A pose's clearance is how far every point of the robot may
//    move from there: all poses nearer than that are free, and are skipped.
// 3. Where the clearances at both ends of a step do not cover it, the poses between them are looked at too, at most
//    half a cell apart.
// 4. For a robot that stands in collision EscapeRule decides what it may overlap, and how.
//
// Why it is right: no point of the robot moves farther in a step than its centre does at the faster of two speeds, and
// its rim by the turn. So what a clearance covers is free. What is left out lies between two free poses at most half a
// cell apart; the braking check of the candidate that is chosen closes that gap for what the robot really does next.
#pragma once

#include <cstddef>

#include "core/collision/check_setup.hpp"
#include "core/collision/clearance_lookup.hpp"
#include "hidwa_local_planner/core/tile.hpp"

namespace hidwa_local_planner {

class RolloutCheck {
 public:
  /// Once per evaluation; the arguments outlive the questions. `radius` [m] reaches from the robot's centre to its
  /// farthest point, `resolution` is the map's [m].
  void prepare(const CheckSetup& setup, ClearanceLookup& clearances, double radius, double resolution);

  /// Whether the cells decide every rollout of a tile; sets the reasons of those that they reject.
  bool decide_by_cells(const Tile& tile, const char** reasons) const;
  /// Sets the reasons of those rollouts of a tile that are not free.
  void check(const Tile& tile, const char** reasons);

 private:
  const char* fault_of(const Tile& tile, std::size_t c);
  bool free(const Tile& tile, std::size_t c);
  double clearance_at(const Tile& tile, std::size_t c, std::size_t k);
  bool free_between(const Tile& tile, std::size_t c, std::size_t k, double before, double after);
  bool escapes(const Tile& tile, std::size_t c) const;
  bool may_stay(const Tile& tile, std::size_t c) const;

  const CheckSetup* setup_ = nullptr;
  ClearanceLookup* clearances_ = nullptr;
  double radius_ = 0.0;       // [m]
  double resolution_ = 0.05;  // [m]
  double margin_ = 0.0;       // around a clear position [m]
  double most_turn_ = 0.0;    // between two poses of the tile, at most [rad]
  std::size_t last_hit_ = 0;  // step at which a candidate of the tile hit something; 0: none yet
};

}  // namespace hidwa_local_planner
