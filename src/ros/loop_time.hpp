// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include <ros/time.h>

namespace hidwa_local_planner {

/// One moment by two clocks: ROS's and the control loop's. With use_sim_time both are /clock. Else the loop's is
/// steady: it goes on evenly while somebody sets the system's clock, so that what was sent and heard keeps its place in
/// time. It equals the system's time until that is set.
struct LoopTime {
  static LoopTime now();

  double seconds = 0.0;                    // of the loop [s]
  ros::Time stamp;                         // of ROS
  double ahead = seconds - stamp.toSec();  // the loop's clock is, of ROS's [s]
  /// A time of ROS by the loop's clock [s]: as long before this moment as by ROS's. 0, no time, stays 0.
  double of(const ros::Time& time) const { return time.isZero() ? 0.0 : time.toSec() + ahead; }
};

/// By how much the system's clock was set. Between two settings that is exactly the same, so that equal stamps stay
/// equal by the loop's clock.
class ClockSettings {
 public:
  /// How far the system's clock was set back in all [ns]. It was read as `system`, between two readings of the steady
  /// clock, `before` and `after` [ns].
  std::int64_t observe(std::int64_t before, std::int64_t system, std::int64_t after);

 private:
  // What changes by less was not set [ns]: both clocks are slewed alike, and no two clocks are read at once.
  static constexpr std::int64_t kLeast = 1000000;

  std::optional<std::int64_t> first_;  // the system's clock was ahead of the steady one [ns]
  std::int64_t ahead_ = 0;             // it is [ns]
};

}  // namespace hidwa_local_planner
