// SPDX-License-Identifier: BSD-3-Clause
#include "core/autonomy/stall_watch.hpp"

#include <algorithm>

namespace hidwa_local_planner {
namespace {

// A fast robot may come to no new pose for this time, too [s].
constexpr double kShortestStall = 1.5;

}  // namespace

void StallWatch::observe(const Motion& motion, const Pose2& pose, double now) {
  stands_.observe(now, motion.stands);
  rests_.observe(now, (motion.stands || motion.creeps) && !motion.yields);
  if (motion.yields) novelty_.reset();
  novelty_.observe(pose, now);
}

bool StallWatch::settled(const Cycle& cycle) const {
  const double latency = cycle.parameters.control_latency + 2.0 * cycle.start.period;
  return stands_.for_at_least(latency, cycle.situation.time);
}

bool StallWatch::gets_nowhere(const Cycle& cycle) const {
  const VelocityLimits& limits = cycle.start.limits;
  const double to_new_pose =
      Novelty::kApart / std::max(limits.x.max, 1e-3) + Novelty::kTurnedApart / std::max(limits.theta.max, 1e-3);
  return novelty_.time_without(cycle.situation.time) >= std::max(kShortestStall, 3.0 * to_new_pose);
}

}  // namespace hidwa_local_planner
