// SPDX-License-Identifier: BSD-3-Clause
// What takes effect one after the other as legs in which both axes change evenly, and the legs of a braking manoeuvre.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "support/naive_effects.hpp"

namespace hidwa_local_planner::test {

struct NaiveLeg {
  Twist2 from, to;
  double duration = 0.0;  // [s]
  Twist2 spread;          // of the commands that take effect where it begins [m, rad]
};

/// Between two times, in order. Where nothing changes before nor after, nor anything takes effect, there is one leg. A
/// base that lags has no spread.
inline std::vector<NaiveLeg> naive_legs(const NaiveEffects& effects, double begin, double end) {
  const std::vector<NaiveEffect>& list = effects.list();
  std::vector<double> cuts{begin, end};
  std::vector<std::pair<double, Twist2>> spreads;  // and from when on
  for (std::size_t i = 0; i < list.size() && list[i].time < end; ++i) {
    const double at = list[i].time, until = i + 1 < list.size() ? std::min(list[i + 1].time, end) : end;
    const Twist2 from = effects.from(i), to = list[i].command;
    cuts.push_back(at);
    for (const double corner : naive_corners(effects.x(), from.v, to.v, effects.lag().v)) {
      cuts.push_back(std::min(at + corner, until));
    }
    for (const double corner : naive_corners(effects.theta(), from.omega, to.omega, effects.lag().omega)) {
      cuts.push_back(std::min(at + corner, until));
    }
    const Twist2 spread{naive_spread(effects.x(), from.v, to.v, until - at),
                        naive_spread(effects.theta(), from.omega, to.omega, until - at)};
    if (at + effects.x().period > begin && !effects.lag().any()) spreads.push_back({std::max(at, begin), spread});
  }
  const auto outside = [&](double t) { return t < begin || t > end; };
  cuts.erase(std::remove_if(cuts.begin(), cuts.end(), outside), cuts.end());
  std::sort(cuts.begin(), cuts.end());
  const auto same = [](double a, double b) { return b - a <= 1e-6; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
  std::vector<NaiveLeg> legs;
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    NaiveLeg leg{effects.velocity(cuts[k - 1]), effects.velocity(cuts[k]), cuts[k] - cuts[k - 1], {}};
    for (const auto& [time, spread] : spreads) {
      const bool here = k + 1 < cuts.size() ? time < cuts[k] - 1e-6 : time <= cuts[k];
      if (!here || time < cuts[k - 1] - 1e-6) continue;
      leg.spread.v += spread.v;
      leg.spread.omega += spread.omega;
    }
    const auto even = [](const NaiveLeg& one) {
      return std::abs(one.to.v - one.from.v) + std::abs(one.to.omega - one.from.omega) < 1e-12;
    };
    if (!legs.empty() && even(legs.back()) && even(leg) && leg.spread.v + leg.spread.omega <= 0.0) {
      legs.back().duration += leg.duration;
    } else {
      legs.push_back(leg);
    }
  }
  return legs;
}

/// An axis that brakes from `begin`, after `t` [s]: at its limit until half a period's worth is left, then evenly over
/// a period. One that lags brakes at its limit until it rests.
inline double naive_braking(const NaiveAxis& axis, double begin, double t, bool lags = false) {
  if (lags) return std::copysign(std::max(0.0, std::abs(begin) - axis.braking * t), begin);
  const double tail = std::min(std::abs(begin), axis.braking * axis.period / 2);
  const double at_limit = (std::abs(begin) - tail) / axis.braking;
  const double left = t < at_limit ? std::abs(begin) - axis.braking * t : tail * (1 - (t - at_limit) / axis.period);
  return std::copysign(std::max(0.0, left), begin);
}
/// When it begins its tail, and when it rests [s].
inline double naive_tail_begins(const NaiveAxis& axis, double begin, bool lags = false) {
  return lags ? std::abs(begin) / axis.braking : std::max(0.0, std::abs(begin) / axis.braking - axis.period / 2);
}
inline double naive_rests(const NaiveAxis& axis, double begin, bool lags = false) {
  return begin == 0.0 ? 0.0 : naive_tail_begins(axis, begin, lags) + (lags ? 0.0 : axis.period);
}
/// What the ways to brake the tail differ by: it is a command like any other.
inline double naive_tail_spread(const NaiveAxis& axis, double begin) {
  return naive_spread(axis, std::min(std::abs(begin), axis.braking * axis.period / 2), 0.0, axis.period);
}

/// From `u` a command, kept until braking begins a period and `hold` [s] after it took effect, then rest. `evenly`: by
/// a base that reaches the command evenly over the period. `lag`: by one that lags.
inline std::vector<NaiveLeg> naive_brake_legs(const Parameters& p, double period, const Twist2& u,
                                              const Twist2& command, double hold, bool evenly = false,
                                              const NaiveLag& lag = {}) {
  const NaiveEffects sent = NaiveEffects(p, period, u, {{0.0, command}}).lagging(0, lag);
  const double end = period + hold;
  std::vector<NaiveLeg> legs;
  std::vector<double> cuts{0.0, end};
  for (const double corner : naive_corners(sent.x(), u.v, command.v, lag.v)) cuts.push_back(std::min(corner, end));
  for (const double corner : naive_corners(sent.theta(), u.omega, command.omega, lag.omega)) {
    cuts.push_back(std::min(corner, end));
  }
  std::sort(cuts.begin(), cuts.end());
  if (evenly) cuts = {0.0, period, end};
  for (std::size_t k = 1; k < cuts.size(); ++k) {
    legs.push_back({sent.velocity(cuts[k - 1]), sent.velocity(cuts[k]), cuts[k] - cuts[k - 1], {}});
  }
  legs[0].spread = {naive_spread(sent.x(), u.v, command.v, end),
                    naive_spread(sent.theta(), u.omega, command.omega, end)};
  const Twist2 fast = sent.velocity(end);
  std::vector<double> stops{0.0, naive_tail_begins(sent.x(), fast.v, lag.v), naive_rests(sent.x(), fast.v, lag.v),
                            naive_tail_begins(sent.theta(), fast.omega, lag.omega),
                            naive_rests(sent.theta(), fast.omega, lag.omega)};
  std::sort(stops.begin(), stops.end());
  for (std::size_t k = 1; k < stops.size(); ++k) {
    const auto at = [&](double t) {
      return Twist2{naive_braking(sent.x(), fast.v, t, lag.v), naive_braking(sent.theta(), fast.omega, t, lag.omega)};
    };
    NaiveLeg leg{at(stops[k - 1]), at(stops[k]), stops[k] - stops[k - 1], {}};
    // The last command to brake comes when a period's worth is left, half a period before the tail.
    const auto comes = [&](double tail) {
      return stops[k] > tail - period / 2 && (k == 1 || stops[k - 1] <= tail - period / 2);
    };
    if (comes(naive_tail_begins(sent.x(), fast.v))) leg.spread.v = naive_tail_spread(sent.x(), fast.v);
    if (comes(naive_tail_begins(sent.theta(), fast.omega)))
      leg.spread.omega = naive_tail_spread(sent.theta(), fast.omega);
    legs.push_back(leg);
  }
  for (NaiveLeg& leg : legs) leg.spread = lag.any() ? Twist2{} : leg.spread;
  return legs;
}

/// No point `radius` [m] from the centre moves farther in the leg [m].
inline double naive_reach(const NaiveLeg& leg, double radius) {
  const auto speed = [radius](const Twist2& u) { return std::abs(u.v) + radius * std::abs(u.omega); };
  return std::max(speed(leg.from), speed(leg.to)) * leg.duration;
}

}  // namespace hidwa_local_planner::test
