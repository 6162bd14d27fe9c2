// SPDX-License-Identifier: BSD-3-Clause
// Gets a robot out of a collision when nobody steers.
//
// 1. It takes at once the legal candidate that ends least deep.
// 2. Where there is none it turns, after some patience, to the nearest heading from which a short way straight on leads
//    out. It goes on until it is out, or for 15 s.
//
// Why it is safe: it takes legal candidates only, and EscapeRule has judged each of them.
#pragma once

#include <vector>

#include "core/collision/admissibility.hpp"
#include "core/collision/escape.hpp"
#include "core/motion/rollout.hpp"
#include "hidwa_local_planner/core/planner.hpp"

namespace hidwa_local_planner {

class EscapeTurn {
 public:
  /// One cycle of a robot that overlaps something, with all candidates checked and scored.
  struct Scene {
    const Situation& situation;
    const GridView& grid;
    const Rollout& rollout;
    const std::vector<double>& totals;  // of each candidate, infinite where it is rejected
    AdmissibilityCheck& admissibility;
    EscapeRule& escape;
  };
  void reset() { *this = EscapeTurn(); }
  /// It may turn.
  bool active() const { return active_; }
  /// The patience is over.
  void begin(double now);
  /// The candidate that leads out; -1 where there is none.
  int choose(const Scene& scene);

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.active_, self.begun_, self.turning_, self.heading_);
  }

 private:
  int out_of_collision(const Scene& scene) const;
  int towards_way_out(const Scene& scene);
  int turn_by(const Scene& scene, double angle) const;
  bool leads_out(const Scene& scene, double heading) const;

  bool active_ = false;
  double begun_ = 0.0;    // [s]
  bool turning_ = false;  // to a heading that leads out
  double heading_ = 0.0;  // that one, costmap frame [rad]
};

}  // namespace hidwa_local_planner
