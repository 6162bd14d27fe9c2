// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>

namespace hidwa_local_planner::input {

/// Notices when the whole planner was paused: the machine is busy, or the process was suspended. During a pause no
/// cycle runs and no message is taken.
///
/// That needs a heartbeat of the thread that takes messages at least every 0.1 s; before the first one there are no
/// pauses.
class PauseDetector {
 public:
  /// The thread that takes messages sends heartbeats from now on.
  void expect_heartbeats() { expected_ = true; }
  /// Some part of the planner works at `now` [s]. Returns the length of the pause that ends now [s]; 0 where there was
  /// none.
  double observe(double now);
  /// A pause of so long [s] ended at `now` [s], while the operator steered: advice() tells of a long one.
  void report(double pause, double now);
  /// A cycle begins: messages of the pause before it were taken.
  void begin_cycle() { ended_ = false; }
  /// A pause ended since the last cycle, or lasts at `now` [s].
  bool since_last_cycle(double now) const { return ended_ || still_for(now) > 0.0; }
  /// A sentence with the remedy where a pause was reported lately; else empty.
  std::string advice(double now) const;

  /// What was reported is forgotten; heartbeats go on.
  void restart();
  /// The clock was set back.
  void set_back();

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.expected_, self.last_);
  }

 private:
  double still_for(double now) const;

  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  bool expected_ = false;
  double last_ = kNever;   // something was at work [s]
  bool ended_ = false;     // a pause, since the last cycle
  double reported_ = 0.0;  // the newest one [s]; 0: none lately
  double reported_at_ = kNever;
};

}  // namespace hidwa_local_planner::input
