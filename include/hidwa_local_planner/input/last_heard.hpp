// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <limits>

namespace hidwa_local_planner::input {

/// When something was heard last. The longest pause of the planner's own since then is no silence.
class LastHeard {
 public:
  void hear(double time) {
    time_ = time;
    longest_pause_ = 0.0;
  }
  /// The planner stood still for `pause` [s], until now.
  void excuse(double pause) { longest_pause_ = std::max(longest_pause_, pause); }
  double time() const { return time_; }  // [s]; minus infinity: never
  double silence(double now) const { return now - time_ - longest_pause_; }

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.time_, self.longest_pause_);
  }

 private:
  double time_ = -std::numeric_limits<double>::infinity();
  double longest_pause_ = 0.0;  // [s]
};

}  // namespace hidwa_local_planner::input
