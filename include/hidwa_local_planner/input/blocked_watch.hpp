// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hidwa_local_planner::input {

/// Measures for how long refusals have held a steered robot at rest.
class BlockedWatch {
 public:
  /// One cycle's outcome at `now` [s].
  void observe(double now, bool held_at_rest) {
    if (!held_at_rest) {
      held_ = false;
    } else if (!held_ || now < since_) {
      held_ = true;
      since_ = now;
    }
  }
  void reset() { held_ = false; }
  bool blocked(double now, double blocked_time) const { return held_ && now - since_ >= blocked_time; }

 private:
  bool held_ = false;
  double since_ = 0.0;  // [s]
};

}  // namespace hidwa_local_planner::input
