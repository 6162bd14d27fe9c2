// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

namespace hidwa_local_planner::input {

/// For how long a sender has been silent. The longest pause of the planner itself since the last message is no silence.
class SilenceTimer {
 public:
  /// A message arrived at `time` [s].
  void restart(double time) {
    time_ = time;
    longest_pause_ = 0.0;
  }
  /// The planner itself did not listen for `pause` [s], until now.
  void exclude_pause(double pause) { longest_pause_ = std::max(longest_pause_, pause); }
  double silence(double now) const { return now - time_ - longest_pause_; }  // [s]; infinite before the first message

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.time_, self.longest_pause_);
  }

 private:
  double time_ = -std::numeric_limits<double>::infinity();  // [s]
  double longest_pause_ = 0.0;                              // [s]
};

}  // namespace hidwa_local_planner::input
