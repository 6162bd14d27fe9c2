// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>

namespace hidwa_local_planner {

/// One moment by two clocks: ROS's and the control loop's. With use_sim_time both are /clock. Else the loop's is
/// steady: it goes on evenly while somebody sets the system's clock, so that what was sent and heard keeps its place in
/// time. It began as the system's time.
struct LoopTime {
  static LoopTime now();

  double seconds = 0.0;  // of the loop [s]
  ros::Time stamp;       // of ROS
  /// A time of ROS by the loop's clock [s]: as long before this moment as by ROS's. 0, no time, stays 0.
  double of(const ros::Time& time) const { return time.isZero() ? 0.0 : time.toSec() + (seconds - stamp.toSec()); }
};

}  // namespace hidwa_local_planner
