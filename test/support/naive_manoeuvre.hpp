// SPDX-License-Identifier: BSD-3-Clause
// A command and then a stop, integrated in steps of a millisecond.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hidwa_local_planner/core/parameters.hpp"
#include "hidwa_local_planner/core/types.hpp"
#include "support/naive_effects.hpp"

namespace hidwa_local_planner::test {

struct NaiveManoeuvre {
  Pose2 start;
  NaiveEffects effects;                         // the command's own, at the latency, is the last
  Twist2 command;                               // [m/s, rad/s]
  double latency = 0.0, period = 0.05;          // [s]
  double braking_x = 1.0, braking_theta = 1.0;  // [m/s^2, rad/s^2]
};

/// `under_way`, then `command`.
inline NaiveManoeuvre naive_manoeuvre(const Parameters& p, const Pose2& start, const NaiveEffects& under_way,
                                      const Twist2& command, double period) {
  return {start,  under_way.then(p.control_latency, command), command, p.control_latency, period, p.braking_x(),
          p.braking_theta()};
}

inline double naive_towards_zero(double value, double by) {
  return std::abs(value) <= by ? 0.0 : value - std::copysign(by, value);
}

/// Velocity at `t` [s]: what takes effect until the command is reached, then braking.
inline Twist2 naive_velocity(const NaiveManoeuvre& m, double t) {
  if (t < m.latency + m.period) return m.effects.velocity(t);
  const double braked = t - m.latency - m.period;
  return {naive_towards_zero(m.command.v, m.braking_x * braked),
          naive_towards_zero(m.command.omega, m.braking_theta * braked)};
}

/// The poses, start included, whenever a point `radius` [m] from the centre may have moved by `spacing` [m];
/// the last is the one at rest.
inline std::vector<Pose2> naive_poses(const NaiveManoeuvre& m, double radius, double spacing) {
  const double end =
      m.latency + m.period +
      std::max(std::abs(m.command.v) / m.braking_x, std::abs(m.command.omega) / m.braking_theta);
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
