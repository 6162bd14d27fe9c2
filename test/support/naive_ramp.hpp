// SPDX-License-Identifier: BSD-3-Clause
// One axis on its way to a velocity: at its limit, evenly, or in any way between the two.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace hidwa_local_planner::test {

/// Towards `target` for `dt`: going up, a velocity's "age" is v / braking below 0 and v / acc above, and
/// grows by dt.
inline double naive_ramp(double v, double target, double dt, double acc, double braking) {
  if (target < v) return -naive_ramp(-v, -target, dt, acc, braking);
  const double age = (v < 0.0 ? v / braking : v / acc) + dt;
  return std::min(target, age < 0.0 ? age * braking : age * acc);
}

/// An axis that reaches a command within `period` [s], or as fast as its limits allow [unit/s^2].
struct NaiveAxis {
  double acc, braking, period;
};

/// How long the limits take from one velocity to another [s].
inline double naive_needed(const NaiveAxis& axis, double from, double to) {
  if (from * to < 0.0) return std::abs(from) / axis.braking + std::abs(to) / axis.acc;
  return std::abs(to - from) / (std::abs(to) > std::abs(from) ? axis.acc : axis.braking);
}

/// After `t` [s], the two ends of what a base may do [unit/s].
inline double naive_at_limit(const NaiveAxis& axis, double from, double to, double t) {
  return naive_ramp(from, to, t, axis.acc, axis.braking);
}
inline double naive_evenly(const NaiveAxis& axis, double from, double to, double t) {
  return t < axis.period ? from + (to - from) * t / axis.period : to;
}

/// The limits take no more than a period. Then there may be more than one way; where the direction changes, also if
/// they take all of it.
inline bool naive_has_time(const NaiveAxis& axis, double from, double to) {
  return naive_needed(axis, from, to) < axis.period + 1e-9;
}

/// One of them: the farther one, evenly where the direction changes.
inline bool naive_goes_at_limit(const NaiveAxis& axis, double from, double to) {
  if (!naive_has_time(axis, from, to)) return true;
  return from * to >= 0.0 && std::abs(to) > std::abs(from);
}
inline double naive_farthest(const NaiveAxis& axis, double from, double to, double t) {
  return naive_goes_at_limit(axis, from, to) ? naive_at_limit(axis, from, to, t) : naive_evenly(axis, from, to, t);
}

/// The other end, where there are two.
inline bool naive_lags_at_limit(const NaiveAxis& axis, double from, double to) {
  return !naive_has_time(axis, from, to) || !naive_goes_at_limit(axis, from, to);
}
inline double naive_lagging(const NaiveAxis& axis, double from, double to, double t) {
  return naive_lags_at_limit(axis, from, to) ? naive_at_limit(axis, from, to, t) : naive_evenly(axis, from, to, t);
}

/// When it stops changing as it did: at rest between two directions, and where it arrives [s].
inline std::vector<double> naive_corners(const NaiveAxis& axis, double from, double to, bool lags = false) {
  if (!(lags ? naive_lags_at_limit(axis, from, to) : naive_goes_at_limit(axis, from, to))) return {axis.period};
  const double needed = naive_needed(axis, from, to);
  return from * to < 0.0 ? std::vector<double>{std::abs(from) / axis.braking, needed} : std::vector<double>{needed};
}

/// How far apart the two ends get until `t` [s]: their difference, joined by straight lines between the corners of
/// either. A command that is cut short leaves a difference, which stays until the next one is reached and then goes
/// down at the limit.
inline double naive_spread(const NaiveAxis& axis, double from, double to, double t) {
  if (!naive_has_time(axis, from, to)) return 0.0;
  const auto apart = [&](double at) {
    return std::abs(naive_at_limit(axis, from, to, at) - naive_evenly(axis, from, to, at));
  };
  std::vector<double> times{0.0, t};
  for (const double corner :
       {from * to < 0.0 ? std::abs(from) / axis.braking : 0.0, naive_needed(axis, from, to), axis.period}) {
    if (corner > 0.0 && corner < t) times.push_back(corner);
  }
  std::sort(times.begin(), times.end());
  double area = 0.0;
  for (std::size_t k = 1; k < times.size(); ++k) {
    area += (apart(times[k - 1]) + apart(times[k])) / 2 * (times[k] - times[k - 1]);
  }
  return area + apart(t) * axis.period * 1.5;
}

}  // namespace hidwa_local_planner::test
