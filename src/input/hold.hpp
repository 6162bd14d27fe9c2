// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hidwa_local_planner::input {

/// After a release the robot drives straight on for a while: u_h = (v_h at release, 0) for delta.
/// Kalliokoski 2022, section III, the delay of the transition to autonomous navigation.
class Hold {
 public:
  /// The input ended at `time` [s] with the velocity v [m/s].
  void begin(double time, double v) {
    begun_ = true;
    time_ = time;
    v_ = v;
  }
  void end() { begun_ = false; }
  /// delta in [s], in time and not in cycles.
  bool running(double now, double delta) const { return begun_ && now - time_ < delta; }
  double v() const { return v_; }  // [m/s]

  template <typename Self, typename Archive>
  static void archive(Self& self, Archive& io) {
    io(self.begun_, self.time_, self.v_);
  }

 private:
  bool begun_ = false;
  double time_ = 0.0;  // [s]
  double v_ = 0.0;     // [m/s]
};

}  // namespace hidwa_local_planner::input
