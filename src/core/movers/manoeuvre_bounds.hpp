// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/motion/cycle_start.hpp"

namespace hidwa_local_planner {

/// What the manoeuvres of a cycle come to at most, whatever is commanded.
struct ManoeuvreBounds {
  double reach = 0.0;       // of the robot's centre until rest [m]
  double drift = 0.0;       // [m]
  double grown = 0.0;       // the robot's part of what sets grow by [m]
  double fastest = 0.0;     // of the outline [m/s]
  double duration = 0.0;    // of the longest one [s]
  double creeps_for = 0.0;  // one of a robot that creeps [s]

  /// `radius`: circumscribed [m]. Poses are no farther apart in time than `step` [s]. A robot that creeps is no faster
  /// than `creeping` [m/s].
  static ManoeuvreBounds of(const CycleStart& start, double radius, double step, double creeping) {
    const VelocityLimits& limits = start.limits;
    const Twist2 fastest =
        larger_of(start.pending->fastest(), {std::abs(start.reference.v) + limits.x.acc * start.period,
                                             std::abs(start.reference.omega) + limits.theta.acc * start.period});
    double latency = 0.0;
    for (std::size_t motion = 0; motion < start.pending->all(); ++motion) {
      latency = std::max(latency, duration_of((*start.pending)[motion]));
    }
    ManoeuvreBounds most;
    most.fastest = speed_at(fastest, radius);
    // The command for two periods and as late as it may be, braking, and the tail of braking.
    const double late = start.latest_hold();
    most.creeps_for = latency + start.period + late + limits.x.time_to_rest(creeping);
    most.duration = latency + 3.0 * start.period + late +
                    std::max(limits.x.time_to_rest(fastest.v), limits.theta.time_to_rest(fastest.omega));
    most.reach = fastest.v * most.duration;
    most.drift = start.most_drift(radius, most.reach);
    most.grown =
        most.drift + 0.5 * (step + late_times_apart(late, start.period)) * (most.fastest + fastest.omega * most.reach);
    return most;
  }

 private:
  // Until the command takes effect [s].
  static double duration_of(const PendingMotion& pending) {
    double sum = 0.0;
    for (std::size_t i = pending.past(); i < pending.legs().size(); ++i) sum += pending.legs()[i].duration;
    return sum;
  }
};

}  // namespace hidwa_local_planner
