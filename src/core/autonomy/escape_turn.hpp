// SPDX-License-Identifier: BSD-3-Clause
// Gets a robot out of a collision when nobody steers.
//
// 1. It takes at once the legal candidate that ends least deep.
// 2. Where there is none it turns, after some patience, to the nearest heading from which a short way straight on leads
//    out. It goes on until it is out, or for 15 s.
//
// Why it is safe: it takes legal candidates only, and EscapeRule has judged each of them.
#pragma once

#include "core/evaluation/evaluation.hpp"

namespace hidwa_local_planner {

class EscapeTurn {
 public:
  struct State {
    bool active = false;   // the robot may turn
    double begun = 0.0;    // [s]
    bool turning = false;  // to a heading that leads out
    double heading = 0.0;  // that one, costmap frame [rad]
    template <typename Self, typename Archive>
    static void archive(Self& self, Archive& io) {
      io(self.active, self.begun, self.turning, self.heading);
    }
  };
  /// What a cycle proposes.
  struct Step {
    int candidate = -1;  // that leads out
    State next;          // to be remembered
  };
  void reset() { state_ = {}; }
  bool active() const { return state_.active; }
  /// The patience is over. `now` [s].
  void begin(double now) { state_ = {true, now, false, state_.heading}; }
  /// Where the robot overlaps something, and all candidates are checked and scored.
  Step propose(const Cycle& cycle, Evaluation& evaluated) const;
  void commit(const Step& step) { state_ = step.next; }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.state_);
  }

 private:
  State state_;
};

}  // namespace hidwa_local_planner
