// SPDX-License-Identifier: BSD-3-Clause
// A command and then a stop, integrated in steps of a millisecond.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "support/naive_legs.hpp"

namespace hidwa_local_planner::test {

struct NaiveManoeuvre {
  Pose2 start;
  NaiveEffects effects;  // the command's own is the last
  double kept = 0.0;     // until the first command to brake takes effect [s]
};

/// `pending`, then `command`; the first command to brake takes effect a period and `hold` [s] after it.
inline NaiveManoeuvre naive_manoeuvre(const Parameters& p, const Pose2& start, const NaiveEffects& pending,
                                      const Twist2& command, double period, double hold = 0.0) {
  return {start, pending.then(p.control_latency, command), p.control_latency + period + hold};
}

/// Velocity at `t` [s].
inline Twist2 naive_velocity(const NaiveManoeuvre& m, double t) {
  if (t < m.kept) return m.effects.velocity(t);
  const Twist2 begin = m.effects.velocity(m.kept);
  const NaiveLag& lag = m.effects.lag();
  return {naive_braking(m.effects.x(), begin.v, t - m.kept, lag.v),
          naive_braking(m.effects.theta(), begin.omega, t - m.kept, lag.omega)};
}

/// The poses, start included, whenever a point `radius` [m] from the centre may have moved by `spacing` [m];
/// the last is the one at rest.
inline std::vector<Pose2> naive_poses(const NaiveManoeuvre& m, double radius, double spacing) {
  const Twist2 begin = m.effects.velocity(m.kept);
  const double end =
      m.kept + std::max(naive_rests(m.effects.x(), begin.v), naive_rests(m.effects.theta(), begin.omega));
  const int steps = static_cast<int>(std::ceil(end / 0.001)) + 1;
  const double dt = end / steps;
  std::vector<Pose2> poses{m.start};
  Pose2 pose = m.start;
  double moved = 0.0;
  for (int k = 0; k < steps; ++k) {
    const Twist2 u = naive_velocity(m, (k + 0.5) * dt);
    pose.x += u.v * std::cos(pose.theta + 0.5 * u.omega * dt) * dt;
    pose.y += u.v * std::sin(pose.theta + 0.5 * u.omega * dt) * dt;
    pose.theta += u.omega * dt;
    moved += (std::abs(u.v) + std::abs(u.omega) * radius) * dt;
    if (moved >= spacing) {
      poses.push_back(pose);
      moved = 0.0;
    }
  }
  poses.push_back(pose);
  return poses;
}

}  // namespace hidwa_local_planner::test
