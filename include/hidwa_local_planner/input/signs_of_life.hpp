// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace hidwa_local_planner::input {

/// Notices when the whole planner stood still: a busy machine, or a process that was suspended. Then neither cycles
/// ran nor were messages taken, and what came meanwhile could not be heard.
///
/// That can be told only where the thread that takes messages says at least every 0.1 s that it is at work; before it
/// said so once, there are no pauses.
class SignsOfLife {
 public:
  /// The thread that takes messages is at work.
  void expect() { expected_ = true; }
  /// Something of the planner is at work at `now` [s]. Returns for how long nothing was until then [s]; 0 where that is
  /// no pause.
  double observe(double now) {
    const double pause = still_for(now);
    last_ = std::max(last_, now);
    return pause;
  }
  /// For how long nothing has been at work at `now` [s]; 0 where that is no pause.
  double still_for(double now) const {
    const double still = now - last_;
    return expected_ && std::isfinite(still) && still > kPause ? still : 0.0;
  }
  /// The clock was set back.
  void forget_time() { last_ = kNever; }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.expected_, self.last_);
  }

 private:
  static constexpr double kPause = 0.15;  // [s]
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  bool expected_ = false;
  double last_ = kNever;  // [s]
};

}  // namespace hidwa_local_planner::input
