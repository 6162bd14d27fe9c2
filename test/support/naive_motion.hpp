// SPDX-License-Identifier: BSD-3-Clause
// Limits, samples and rollouts, one candidate at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "support/naive_collision.hpp"
#include "support/naive_ramp.hpp"
#include "support/scene.hpp"

namespace hidwa_local_planner::test {

inline double naive_ramp_v(const Parameters& p, double v, double target, double dt) {
  return naive_ramp(v, target, dt, p.acc_lim_x, p.braking_x());
}
inline double naive_ramp_omega(const Parameters& p, double omega, double target, double dt) {
  return naive_ramp(omega, target, dt, p.acc_lim_theta, p.braking_theta());
}

/// The limits as a gentle turn from `omega` to `target` has them: evenly over the comfort time, within the comfort
/// limit.
inline Parameters naive_gentle(Parameters p, double omega, double target) {
  if (std::abs(omega) > p.max_vel_theta) return p;  // brought back first
  double most = p.comfort_acc_lim_theta;
  if (p.comfort_turn_time > 0.0) most = std::min(most, std::abs(target - omega) / p.comfort_turn_time);
  const double acc = std::min(p.acc_lim_theta, most), braking = std::min(p.braking_theta(), most);
  p.acc_lim_theta = acc;
  p.decel_lim_theta = braking;
  return p;
}

/// Likewise of a turn that comes to rest at the goal.
inline Parameters naive_gentle_rest(Parameters p, double omega) {
  p.comfort_turn_time = 0.0;
  return naive_gentle(p, omega, 0.0);
}

inline double naive_wheel_room(const Parameters& p,
                               double omega) {  // [m/s] left for driving; infinite without wheels
  if (!p.has_wheel_limit()) return INFINITY;
  return p.max_wheel_speed - 0.5 * p.wheel_separation * std::abs(omega);
}
inline bool naive_wheels_allow(const Parameters& p, const Twist2& u) {
  return std::abs(u.v) <= naive_wheel_room(p, u.omega) + 1e-9;
}
inline double naive_clip(double value, double lo, double hi) { return value < lo ? lo : value > hi ? hi : value; }

inline Twist2 naive_inside_limits(const Parameters& p, Twist2 u) {
  u.v = naive_clip(u.v, std::min(0.0, p.min_vel_x), p.max_vel_x);
  u.omega = naive_clip(u.omega, -p.max_vel_theta, p.max_vel_theta);
  if (naive_wheels_allow(p, u)) return u;
  const double most = p.max_wheel_speed / (0.5 * p.wheel_separation);
  u.omega = naive_clip(u.omega, -most, most);
  const double room = std::max(0.0, naive_wheel_room(p, u.omega));
  u.v = naive_clip(u.v, -room, room);
  return u;
}

/// One period towards a sample; where the wheels cut it, v gives way as far as braking allows, then omega.
inline Twist2 naive_command(const Parameters& p, const Twist2& reference, const Twist2& sample, double period) {
  Twist2 u{naive_ramp_v(p, reference.v, sample.v, period), naive_ramp_omega(p, reference.omega, sample.omega, period)};
  if (naive_wheels_allow(p, u)) return u;
  const double slowest = naive_ramp_v(p, reference.v, 0.0, period);
  const double room = std::max(0.0, naive_wheel_room(p, u.omega));
  u.v = std::abs(slowest) > std::min(std::abs(u.v), room) ? slowest : naive_clip(u.v, -room, room);
  if (naive_wheels_allow(p, u)) return u;
  const double straightest = naive_ramp_omega(p, reference.omega, 0.0, period);
  const double turn = std::max(0.0, (p.max_wheel_speed - std::abs(u.v)) / (0.5 * p.wheel_separation));
  u.omega = std::abs(straightest) > std::min(std::abs(u.omega), turn) ? straightest : naive_clip(u.omega, -turn, turn);
  return u;
}

struct NaiveWindow {
  double v_lo, v_hi, omega_lo, omega_hi;
};

inline void naive_reach(double lowest, double highest, double min, double max, double& lo, double& hi) {
  lo = std::max(lowest, min);
  hi = std::min(highest, max);
  if (lowest > max) lo = hi = lowest;  // still too fast after braking: that end alone
  if (highest < min) lo = hi = highest;
}

inline NaiveWindow naive_window(const Parameters& p, const Twist2& reference, double period) {
  const double dt = p.generator == Generator::standard ? std::max(p.sim_time, period) : period;
  NaiveWindow w{};
  naive_reach(naive_ramp_v(p, reference.v, -1e6, dt), naive_ramp_v(p, reference.v, 1e6, dt), std::min(0.0, p.min_vel_x),
              p.max_vel_x, w.v_lo, w.v_hi);
  naive_reach(naive_ramp_omega(p, reference.omega, -1e6, dt), naive_ramp_omega(p, reference.omega, 1e6, dt),
              -p.max_vel_theta, p.max_vel_theta, w.omega_lo, w.omega_hi);
  return w;
}

inline std::vector<double> naive_values(double lo, double hi, int count) {
  if (hi <= lo) return {lo};
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(lo + (hi - lo) * i / (count - 1));
  bool has_zero = false;
  for (double& value : values) {
    if (std::abs(value) < 1e-12) value = 0.0;  // rounding
    has_zero = has_zero || value == 0.0;
  }
  if (lo < 0.0 && hi > 0.0 && !has_zero) values.push_back(0.0);
  std::sort(values.begin(), values.end());
  return values;
}

inline double naive_dead_band(const Parameters& p, double v) {
  return std::abs(v) < 0.01 ? p.min_in_place_vel_theta : 0.0;
}

/// Driving forward, but more slowly than min_vel_x and than the window allows.
inline bool naive_creeps(const Parameters& p, const NaiveWindow& w, double v) {
  return v > 0.0 && v < p.min_vel_x && v < w.v_hi - 1e-12;
}

inline Twist2 naive_into_window(const Parameters& p, const NaiveWindow& w, const Twist2& wanted) {
  Twist2 u =
      naive_inside_limits(p, {naive_clip(wanted.v, w.v_lo, w.v_hi), naive_clip(wanted.omega, w.omega_lo, w.omega_hi)});
  if (naive_creeps(p, w, u.v)) {
    const double least = std::min(p.min_vel_x, w.v_hi);
    u = naive_inside_limits(p, {u.v < least / 2 ? 0.0 : least, u.omega});
  }
  const double band = naive_dead_band(p, u.v);
  if (u.omega == 0.0 || std::abs(u.omega) >= band) return u;
  u.omega = std::abs(u.omega) < band / 2 ? 0.0 : u.omega > 0.0 ? band : -band;
  u = naive_inside_limits(p, u);
  if (std::abs(u.omega) < naive_dead_band(p, u.v)) u.omega = 0.0;
  return u;
}

struct NaiveCandidate {
  Twist2 u;
  bool brake = false;
  std::vector<Pose2> poses;    // of the rollout, start included
  std::vector<double> omegas;  // likewise [rad/s]
  double dt = 0.0;             // [s]
  std::string rejected_by;     // empty while legal
  std::vector<double> raw;     // per critic
  double total = 0.0;
};

inline std::vector<NaiveCandidate> naive_candidates(const Scene& scene, const Twist2& reference, bool gentle = false) {
  const Parameters& p = scene.parameters;
  const NaiveWindow w =
      naive_window(gentle ? naive_gentle(p, reference.omega, 1e9) : p, reference, scene.situation.period);
  std::vector<NaiveCandidate> all;
  const auto add = [&all](const Twist2& u, bool brake = false) {
    NaiveCandidate candidate;
    candidate.u = u;
    candidate.brake = brake;
    all.push_back(candidate);
  };
  for (const double omega : naive_values(w.omega_lo, w.omega_hi, p.vth_samples)) {
    for (const double v : naive_values(w.v_lo, w.v_hi, p.vx_samples)) {
      if ((v == 0.0 && omega == 0.0) || naive_creeps(p, w, v)) continue;
      if (omega != 0.0 && std::abs(omega) < naive_dead_band(p, v)) continue;
      if (naive_wheels_allow(p, {v, omega})) add({v, omega});
    }
  }
  const double edge = p.min_in_place_vel_theta;
  if (edge > 0.0 && w.v_lo <= 0.0 && w.v_hi >= 0.0) {
    if (naive_wheels_allow(p, {0.0, -edge})) add({0.0, -edge});
    if (naive_wheels_allow(p, {0.0, edge})) add({0.0, edge});
  }
  add({}, true);  // braking is always tried in these scenes
  if (p.method == Method::hidwa && scene.intent.influence != Influence::none)
    add(naive_into_window(p, w, scene.intent.u_h));
  const Twist2 previous = naive_into_window(p, w, scene.situation.last_command);
  if (p.method == Method::hidwa && (previous.v != 0.0 || previous.omega != 0.0)) add(previous);
  return all;
}

/// How long candidates are rolled out: where autonomy drives, no longer than the slowest drive to the goal takes.
inline double naive_sim_time(const Scene& scene) {
  const Parameters& p = scene.parameters;
  const bool autonomous = scene.intent.influence == Influence::none && !scene.situation.goal_latched;
  const double step = p.generator == Generator::standard ? p.max_vel_x / (p.vx_samples - 1) : 0.0;
  const double slowest = p.min_vel_x > step ? p.min_vel_x : step;
  if (!autonomous || p.admissibility != Admissibility::braking || slowest <= 0.0) return p.sim_time;
  const double dx = scene.situation.goal.x - scene.situation.pose.x,
               dy = scene.situation.goal.y - scene.situation.pose.y;
  return std::min(p.sim_time, std::max(std::sqrt(dx * dx + dy * dy) / slowest, scene.situation.period));
}

/// Rolls every candidate out.
inline void naive_roll_out(const Scene& scene, const Twist2& reference, std::vector<NaiveCandidate>& all,
                           bool gentle = false) {
  const Parameters& p = scene.parameters;
  const double T = naive_sim_time(scene);
  double fastest = 0.0;
  for (const NaiveCandidate& c : all) fastest = std::max(fastest, std::abs(c.u.v));
  for (NaiveCandidate& c : all) {
    const bool euler = p.method == Method::paper;
    const double speed = euler && !c.brake ? std::abs(c.u.v) : fastest;
    const double n = std::max(
        1.0, std::ceil(std::max(speed * T / p.linear_granularity, std::abs(c.u.omega) * T / p.angular_granularity)));
    c.dt = T / n;
    const bool ramps = c.brake || p.generator == Generator::standard;
    Parameters turn = p;
    if (gentle && !c.brake) turn = naive_gentle(p, reference.omega, c.u.omega);
    if (gentle && c.brake && scene.situation.goal_latched) turn = naive_gentle_rest(p, reference.omega);
    Twist2 now = ramps ? reference : c.u;
    Pose2 q = scene.situation.pose;
    c.poses = {q};
    c.omegas = {now.omega};
    for (int k = 0; k < static_cast<int>(n); ++k) {
      Twist2 next = c.u;
      if (ramps) next = {naive_ramp_v(p, now.v, c.u.v, c.dt), naive_ramp_omega(turn, now.omega, c.u.omega, c.dt)};
      const double v = euler ? next.v : (now.v + next.v) / 2;
      const double omega = euler ? next.omega : (now.omega + next.omega) / 2;
      const double heading = euler ? q.theta : q.theta + omega * c.dt / 2;
      q.x += v * std::cos(heading) * c.dt;
      q.y += v * std::sin(heading) * c.dt;
      q.theta += omega * c.dt;
      c.poses.push_back(q);
      c.omegas.push_back(next.omega);
      now = next;
    }
  }
}

}  // namespace hidwa_local_planner::test
