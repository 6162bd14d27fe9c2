// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/planner/cycle.hpp"

namespace hidwa_local_planner {

/// Where no way leads on, a second search, without what moves, says whether that alone blocks the way. Then the robot
/// waits for it to go, some time, before it fails.
class MoverWait {
 public:
  /// So long it waits [s].
  static constexpr double kLongest = 30.0;

  /// The robot drives, or nobody asks any more.
  void reset() { *this = {}; }
  /// A search begins. Whether what moves counts in it.
  bool counts_movers(const Cycle& cycle) {
    in_task_ = !alone_ && !cycle.situation.moving_obstacles.empty();
    return in_task_;
  }
  /// What moves counts in the search that goes on.
  bool with_movers() const { return in_task_; }
  /// A search found no way. True: search again, without what moves.
  bool try_without() {
    if (!in_task_) return false;
    alone_ = true;
    return true;
  }
  /// The second search goes on, or has found a way.
  bool alone() const { return alone_; }
  /// A search with what moves found no way, and one without did: it waits.
  void begin(double now) {
    alone_ = false;
    if (!waits_) since_ = now;
    waits_ = true;
  }
  bool waits() const { return waits_; }
  /// It has waited as long as it will.
  bool over(double now) const { return waits_ && (now < since_ || now - since_ >= kLongest); }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.in_task_, self.alone_, self.waits_, self.since_);
  }

 private:
  bool in_task_ = false;  // what moves, of the search that goes on
  bool alone_ = false;    // that search leaves it out
  bool waits_ = false;
  double since_ = 0.0;  // [s]
};

}  // namespace hidwa_local_planner
