// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace hidwa_local_planner {
namespace tracking {

/// How far the robot has come since the tracker began: what odometry's error grows with.
struct Travel {
  double driven = 0.0;  // [m]
  double turned = 0.0;  // [rad]
};

/// How far odometry may have shifted a standing thing at `distance` [m] from `before` to `now`, if it errs by the share
/// `slip` [m].
inline double shift(const Travel& before, const Travel& now, double distance, double slip) {
  return slip * (now.driven - before.driven + distance * (now.turned - before.turned));
}

}  // namespace tracking
}  // namespace hidwa_local_planner
