// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/cycle/cycle.hpp"
#include "core/intent/held_direction.hpp"
#include "core/intent/intent_search.hpp"

namespace hidwa_local_planner {

/// What an operator without a goal means, from cycle to cycle: the direction that they hold, and the side on which the
/// robot drives round what is in its way.
class GoallessIntent {
 public:
  void forget() {
    direction_.forget();
    side_ = 0;
  }
  /// Once a cycle in which the operator drives without a goal: what candidates are compared with. A turn counts much
  /// more than a speed: where the target is rejected, the robot rather drives more slowly than elsewhere.
  Steering update(const Cycle& cycle);

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.direction_, self.side_);
  }

 private:
  HeldDirection direction_;
  int side_ = 0;  // see IntentSearch::Request
  IntentSearch search_;
};

/// The motion would be one that the operator does not ask for: forwards while they hold the stick back, or the other
/// way round, or a drive while they only turn. A robot that brakes does not count [m/s, rad/s].
bool against_operator(const Twist2& motion, const Twist2& reference, const Twist2& wanted);

}  // namespace hidwa_local_planner
